#include "io/results/space/seen_npz.h"

#include <cstddef>
#include <utility>

#include "io/files/spool_file.h"
#include "io/files/zip_file.h"
#include "io/results/npy.h"
#include "io/results/space/seen_shares.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

// An array that grows on disk: numbers of one type, some of them a row.
class SpooledArray {
 public:
  SpooledArray(const std::filesystem::path& folder, std::string name, std::string type, std::size_t columns = 0)
      : spool_(folder), name_(std::move(name)), type_(std::move(type)), columns_(columns) {}

  template <class Number>
  void add(Number number) {
    spool_.add(number);
    ++count_;
  }
  std::size_t rows() const { return columns_ == 0 ? count_ : count_ / columns_; }

  void write_into(ZipWriter& zip) {
    std::vector<std::size_t> shape{rows()};
    if (columns_ > 0) shape.push_back(columns_);
    zip.add(name_ + ".npy", [&](const ZipWriter::Sink& sink) {
      sink(npy_header(shape, type_));
      spool_.read(sink);
    });
  }

 private:
  SpoolFile spool_;
  std::string name_, type_;
  std::size_t columns_, count_ = 0;
};

// The pieces of what is seen.
struct PieceArrays {
  SpooledArray of_faces, of_pieces, directions, places;

  explicit PieceArrays(const std::filesystem::path& folder)
      : of_faces(folder, "piece_begin", "<i8"),
        of_pieces(folder, "corner_begin", "<i8"),
        directions(folder, "direction", "<f8", 3),
        places(folder, "place", "<f8", 3) {
    of_faces.add(std::int64_t{0});
    of_pieces.add(std::int64_t{0});
  }

  void add(const VisibilityMap3& map, std::span<const VisibilityMap3::Fragment> fragments) {
    for (const VisibilityMap3::Fragment& fragment : fragments) {
      for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) add(map.corners[c]);
      of_pieces.add(static_cast<std::int64_t>(directions.rows()));
    }
    of_faces.add(static_cast<std::int64_t>(of_pieces.rows()) - 1);
  }

  void write_into(ZipWriter& zip) {
    for (SpooledArray* const array : {&of_faces, &of_pieces, &directions, &places}) array->write_into(zip);
  }

 private:
  void add(const VisibilityMap3::Corner& corner) {
    for (const double x : {corner.direction.x, corner.direction.y, corner.direction.z}) directions.add(x);
    for (const double x : {corner.x, corner.y, corner.z}) places.add(x);
  }
};

class SeenNpz final : public SeenWriter3 {
 public:
  SeenNpz(const SeenFileOptions3& options, std::function<void(std::string_view)> sink)
      : names_(options),
        sink_(std::move(sink)),
        points_(options.folder, "xyz", "<f8", 3),
        begin_(options.folder, "begin", "<i8"),
        face_(options.folder, "face", "<i4"),
        solid_angle_(options.folder, "solid_angle", "<f8"),
        solid_(options.folder, "solid", "<i4") {
    if (options.has_bounds) bounds_.emplace(options.folder, "fraction_bounds", "<f8", 2);
    if (options.has_pieces) pieces_.emplace(options.folder);
    begin_.add(std::int64_t{0});
  }

  void add(const SeenByPoint3& seen) override {
    for (const Rational* const x : {&seen.eye.x, &seen.eye.y, &seen.eye.z}) points_.add(coordinate(*x));
    solid_.add(seen.solid ? names_.of_solid(*seen.solid) : std::int32_t{-1});
    if (!seen.solid)
      for_each_seen(seen, [&](const std::optional<Face>& face, double fraction, const Enclosure* bounds) {
        face_.add(names_.of(face));
        solid_angle_.add(solid_angle_of(fraction));
        if (bounds_ && bounds)
          for (const double bound : {bounds->lower, bounds->upper}) bounds_->add(bound);
        if (pieces_) pieces_->add(seen.map, fragments_of(seen.map, face));
      });
    begin_.add(static_cast<std::int64_t>(face_.rows()));
  }

  void finish() override {
    ZipWriter zip(sink_);
    for (SpooledArray* const array : {&points_, &begin_, &face_, &solid_angle_}) array->write_into(zip);
    zip.add("names.npy", npy_of_texts(names_.all()));
    solid_.write_into(zip);
    if (bounds_) bounds_->write_into(zip);
    if (pieces_) pieces_->write_into(zip);
    zip.finish();
  }

 private:
  static double coordinate(const Rational& number) {
    const double result = written_double(number);
    require_double(result, "a coordinate of a point");
    return result;
  }

  SeenNames3 names_;
  std::function<void(std::string_view)> sink_;
  SpooledArray points_, begin_, face_, solid_angle_, solid_;
  std::optional<SpooledArray> bounds_;
  std::optional<PieceArrays> pieces_;
};

}  // namespace

std::unique_ptr<SeenWriter3> seen_npz_writer(const SeenFileOptions3& options,
                                             std::function<void(std::string_view)> sink) {
  return std::make_unique<SeenNpz>(options, std::move(sink));
}

}  // namespace hottel
