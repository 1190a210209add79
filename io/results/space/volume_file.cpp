#include "io/results/space/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Sink = std::function<void(std::string_view)>;

bool runs_along_axes(const Grid3& grid) {
  const auto is_along = [](const Rational& along, const Rational& a, const Rational& b) {
    return along > 0 && a == 0 && b == 0;
  };
  const Vector3 &u = grid.u, &v = grid.v, &w = *grid.w;
  return is_along(u.x, u.y, u.z) && is_along(v.y, v.x, v.z) && is_along(w.z, w.x, w.y);
}

double written(const Rational& number) {
  const double result = written_double(number);
  require_double(result, "a corner of a volume");
  return result;
}

// Corners in VTK's order: along u first.
std::vector<double> corners_of_cells(const Grid3& grid) {
  std::vector<double> result;
  for (std::uint32_t k = 0; k <= grid.nw; ++k)
    for (std::uint32_t j = 0; j <= grid.nv; ++j)
      for (std::uint32_t i = 0; i <= grid.nu; ++i) {
        const Point3 place = place_in(grid, Rational(i) / Rational(grid.nu), Rational(j) / Rational(grid.nv),
                                      Rational(k) / Rational(grid.nw));
        for (const Rational* const x : {&place.x, &place.y, &place.z}) result.push_back(written(*x));
      }
  return result;
}

// Writes heads of arrays, whose numbers follow at the end of the file, each with its count of bytes before it.
class VolumeWriter {
 public:
  VolumeWriter(const Grid3& grid, const Sink& sink) : grid_(grid), sink_(sink) {}

  void write(std::span<const VolumeValues> values) {
    const bool is_image = runs_along_axes(grid_);
    const std::string kind = is_image ? "ImageData" : "StructuredGrid";
    const std::string extent = fmt::format("0 {} 0 {} 0 {}", grid_.nu, grid_.nv, grid_.nw);
    sink_("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + kind +
          "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <" + kind + " WholeExtent=\"" +
          extent + "\"" + (is_image ? places() : "") + ">\n    <Piece Extent=\"" + extent + "\">\n");
    const std::vector<double> corners = is_image ? std::vector<double>() : corners_of_cells(grid_);
    if (!is_image) write_points(corners);
    write_cells(values);
    sink_("    </Piece>\n  </" + kind + ">\n  <AppendedData encoding=\"raw\">\n   _");
    if (!is_image) append(corners);
    for (const VolumeValues& each : values) append(each.values);
    sink_("\n  </AppendedData>\n</VTKFile>\n");
  }

 private:
  std::string places() const {
    const Point3& o = grid_.origin;
    return fmt::format(" Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", written(o.x), written(o.y), written(o.z),
                       written(grid_.u.x / Rational(grid_.nu)), written(grid_.v.y / Rational(grid_.nv)),
                       written(grid_.w->z / Rational(grid_.nw)));
  }

  void write_points(const std::vector<double>& corners) {
    sink_("      <Points>\n");
    write_head("corners", {"x", "y", "z"}, corners.size());
    sink_("      </Points>\n");
  }

  void write_cells(std::span<const VolumeValues> values) {
    sink_("      <CellData Scalars=\"" + values.front().name + "\">\n");
    for (const VolumeValues& each : values) {
      HOTTEL_REQUIRE(each.values.size() == grid_.cells() * std::max<std::size_t>(1, each.components.size()));
      write_head(each.name, each.components, each.values.size());
    }
    sink_("      </CellData>\n");
  }

  void write_head(const std::string& name, const std::vector<std::string>& components, std::size_t count) {
    std::string names;
    for (std::size_t c = 0; c < components.size(); ++c)
      names += fmt::format(" ComponentName{}=\"{}\"", c, components[c]);
    sink_(
        fmt::format("        <DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"appended\" "
                    "offset=\"{}\"/>\n",
                    name, std::max<std::size_t>(1, components.size()), names, offset_));
    offset_ += sizeof(std::uint64_t) + count * sizeof(double);
  }

  void append(std::span<const double> numbers) {
    const std::uint64_t bytes = numbers.size_bytes();
    sink_({reinterpret_cast<const char*>(&bytes), sizeof bytes});
    sink_({reinterpret_cast<const char*>(numbers.data()), bytes});
  }

  const Grid3& grid_;
  const Sink& sink_;
  std::uint64_t offset_ = 0;
};

}  // namespace

std::string_view volume_ending(const Grid3& grid) { return runs_along_axes(grid) ? ".vti" : ".vts"; }

void write_volume(const Grid3& grid, std::span<const VolumeValues> values, const Sink& sink) {
  HOTTEL_REQUIRE(grid.is_volume() && !values.empty());
  VolumeWriter(grid, sink).write(values);
}

}  // namespace hottel
