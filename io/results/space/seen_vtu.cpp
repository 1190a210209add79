#include "io/results/space/seen_vtu.h"

#include <fmt/format.h>

#include <utility>

#include "io/files/spool_file.h"
#include "io/results/space/seen_shares.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Sink = std::function<void(std::string_view)>;

// An array of cells or points that grows on disk.
struct CellArray {
  const char* type;
  const char* name;  // nothing: of points
  SpoolFile spool;

  CellArray(const std::filesystem::path& folder, const char* its_type, const char* its_name)
      : type(its_type), name(its_name), spool(folder) {}
};

class SeenVtu final : public SeenWriter3 {
 public:
  SeenVtu(const SeenFileOptions3& options, Sink sink)
      : names_(options),
        sink_(std::move(sink)),
        places_(options.folder, "Float64", "places"),
        connectivity_(options.folder, "Int64", "connectivity"),
        offsets_(options.folder, "Int64", "offsets"),
        types_(options.folder, "UInt8", "types"),
        point_(options.folder, "Int64", "point"),
        face_(options.folder, "Int32", "face"),
        solid_angle_(options.folder, "Float64", "solid_angle") {}

  void add(const SeenByPoint3& seen) override {
    if (!seen.solid)
      for_each_seen(seen, [&](const std::optional<Face>& face, double, const Enclosure*) {
        for (const VisibilityMap3::Fragment& fragment : fragments_of(seen.map, face)) add(seen.map, fragment);
      });
    ++points_;
  }

  void finish() override {
    sink_(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n  <UnstructuredGrid>\n");
    write_names();
    sink_(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      <Points>\n", corners_, cells_));
    write_head(places_, 3);
    sink_("      </Points>\n      <Cells>\n");
    for (CellArray* const array : {&connectivity_, &offsets_, &types_}) write_head(*array, 1);
    sink_("      </Cells>\n      <CellData Scalars=\"face\">\n");
    for (CellArray* const array : {&point_, &face_, &solid_angle_}) write_head(*array, 1);
    sink_("      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n   _");
    for (CellArray* const array : {&places_, &connectivity_, &offsets_, &types_, &point_, &face_, &solid_angle_})
      append(array->spool);
    sink_("\n  </AppendedData>\n</VTKFile>\n");
  }

 private:
  void add(const VisibilityMap3& map, const VisibilityMap3::Fragment& fragment) {
    constexpr std::uint8_t kPolygon = 7;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
      const VisibilityMap3::Corner& corner = map.corners[c];
      for (const double x : {corner.x, corner.y, corner.z}) add_place(x);
      connectivity_.spool.add(corners_++);
    }
    offsets_.spool.add(corners_);
    types_.spool.add(kPolygon);
    point_.spool.add(points_);
    face_.spool.add(names_.of(fragment.face));
    solid_angle_.spool.add(solid_angle_of(fragment.fraction));
    ++cells_;
  }

  void add_place(double x) {
    require_double(x, "where a face is seen");
    places_.spool.add(x);
  }

  // Texts are the numbers of their characters, and 0 at the end of each.
  void write_names() {
    const std::vector<std::string> names = names_.all();
    sink_(
        fmt::format("    <FieldData>\n      <DataArray type=\"String\" Name=\"names\" NumberOfTuples=\"{}\" "
                    "format=\"ascii\">\n",
                    names.size()));
    for (const std::string& name : names) {
      std::string line = "        ";
      for (const char c : name) line += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
      sink_(line + "0\n");
    }
    sink_("      </DataArray>\n    </FieldData>\n");
  }

  void write_head(const CellArray& array, int components) {
    sink_(
        fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                    "offset=\"{}\"/>\n",
                    array.type, array.name, components, offset_));
    offset_ += sizeof(std::uint64_t) + array.spool.size();
  }

  void append(SpoolFile& spool) {
    const std::uint64_t bytes = spool.size();
    sink_({reinterpret_cast<const char*>(&bytes), sizeof bytes});
    spool.read(sink_);
  }

  SeenNames3 names_;
  Sink sink_;
  CellArray places_, connectivity_, offsets_, types_, point_, face_, solid_angle_;
  std::int64_t points_ = 0, corners_ = 0;
  std::uint64_t cells_ = 0, offset_ = 0;
};

}  // namespace

std::unique_ptr<SeenWriter3> seen_vtu_writer(const SeenFileOptions3& options, Sink sink) {
  return std::make_unique<SeenVtu>(options, std::move(sink));
}

}  // namespace hottel
