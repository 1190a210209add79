#include "io/results/plane/polygon_npz.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/visibility/polygon_extent.h"
#include "geometry/scene_names.h"
#include "io/files/zip_file.h"
#include "io/results/npy.h"
#include "io/results/plane/polygon_names.h"

namespace hottel {
namespace {

template <class Number>
std::string array_of(const std::vector<Number>& values, std::span<const std::size_t> shape, std::string_view type) {
  std::string bytes = npy_header(shape, type);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
  return bytes;
}

class NpzWriter final : public PolygonWriter2 {
 public:
  NpzWriter(const PreparedScene2& prepared, std::size_t channels, std::optional<Rational> range,
            std::function<void(std::string_view)> sink)
      : prepared_(prepared), channels_(channels), range_(std::move(range)), sink_(std::move(sink)) {}

  void add(const PolygonBatch2& batch) override {
    for (std::size_t k = 0; k < batch.polygons.size(); ++k) {
      const RoundedPolygon2& polygon = batch.polygons[k];
      add_extent(extent_of(batch.eyes[k], polygon, range_));
      for (const RoundedPolygon2::Corner& corner : polygon.corners) {
        require_finite(corner, begin_.size() - 1);
        xy_.push_back(corner.x);
        xy_.push_back(corner.y);
        side_.push_back(place_of(corner.after));
      }
      begin_.push_back(static_cast<std::int64_t>(side_.size()));
      solid_.push_back(polygon.solid == Solids2::kNone ? -1 : place_of_solid(polygon.solid));
    }
    for (const auto& values : batch.irradiance) irradiance_.insert(irradiance_.end(), values.begin(), values.end());
  }

  void finish() override {
    std::vector<std::string> names{"", "sky", "#range"};
    for (auto& [key, place] : index_of_) {
      place = static_cast<std::int32_t>(names.size());
      names.push_back(key.first == Kind::kFace ? face_name(prepared_.scene, Face::of(key.second))
                                               : "#in " + prepared_.scene.groups[key.second].name);
    }
    const auto indices = [&](const std::vector<std::int64_t>& places) {
      std::vector<std::int32_t> result;
      for (const std::int64_t place : places) result.push_back(index_of(place));
      return result;
    };
    const std::size_t points = solid_.size(), corners = side_.size();
    const std::size_t by_corner[] = {corners}, by_point[] = {points}, pairs[] = {corners, 2}, ends[] = {points + 1},
                      light[] = {points, channels_};
    ZipWriter zip(sink_);
    zip.add("xy.npy", array_of(xy_, pairs, "<f8"));
    zip.add("begin.npy", array_of(begin_, ends, "<i8"));
    zip.add("face.npy", array_of(indices(side_), by_corner, "<i4"));
    zip.add("names.npy", npy_of_texts(names));
    zip.add("solid.npy", array_of(indices(solid_), by_point, "<i4"));
    if (channels_ > 0) zip.add("irradiance.npy", array_of(irradiance_, light, "<f8"));
    zip.add("area.npy", array_of(area_, by_point, "<f8"));
    zip.add("perimeter.npy", array_of(perimeter_, by_point, "<f8"));
    zip.finish();
  }

 private:
  // A face or a solid, by number, in the order of the scene.
  enum class Kind { kFace, kSolid };
  using Key = std::pair<Kind, std::uint32_t>;

  void add_extent(const std::optional<PolygonExtent2>& extent) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    area_.push_back(extent ? extent->area : kNaN);
    perimeter_.push_back(extent ? extent->perimeter : kNaN);
  }

  // Until all are known a name is told by a number: -1 none, 0 a ray, 1 the sky, 2 an arc, then twice the number of a
  // face, or of a solid and one more.
  std::int64_t place_of(PieceSideId after) {
    if (after == kNoPiece) return 0;
    if (after == kSky) return 1;
    if (after == kRange) return 2;
    return place_of({Kind::kFace, prepared_.arrangement.owner(after).number()});
  }
  std::int64_t place_of_solid(std::uint32_t group) { return place_of({Kind::kSolid, group}); }
  std::int64_t place_of(const Key& key) {
    index_of_.try_emplace(key, 0);
    return 3 + 2 * std::int64_t{key.second} + (key.first == Kind::kSolid ? 1 : 0);
  }
  std::int32_t index_of(std::int64_t place) const {
    if (place < 3) return static_cast<std::int32_t>(place);
    const Kind kind = (place - 3) % 2 == 0 ? Kind::kFace : Kind::kSolid;
    return index_of_.at({kind, static_cast<std::uint32_t>((place - 3) / 2)});
  }

  const PreparedScene2& prepared_;
  const std::size_t channels_;
  const std::optional<Rational> range_;
  const std::function<void(std::string_view)> sink_;
  std::vector<double> xy_, irradiance_, area_, perimeter_;
  std::vector<std::int64_t> begin_{0}, side_, solid_;
  std::map<Key, std::int32_t> index_of_;
};

}  // namespace

std::unique_ptr<PolygonWriter2> polygon_npz_writer(const PreparedScene2& prepared, std::size_t channels,
                                                   std::optional<Rational> range,
                                                   std::function<void(std::string_view)> sink) {
  return std::make_unique<NpzWriter>(prepared, channels, std::move(range), std::move(sink));
}

}  // namespace hottel
