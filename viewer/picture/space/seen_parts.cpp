#include "viewer/picture/space/seen_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "viewer/picture/space/eye_map.h"
#include "viewer/picture/space/seen_sides.h"

namespace hottel {
namespace {

double weighted(std::span<const double> weights, std::span<const double> value) {
  double sum = 0;
  for (std::size_t c = 0; c < weights.size(); ++c) sum += weights[c] * value[c];
  return sum;
}

void add(const AffineValue3& value, double factor, AffineValue3& sum) {
  sum.x += factor * value.x;
  sum.y += factor * value.y;
  sum.one += factor * value.one;
}

struct PixelBox {
  double left = 0, right = 0, top = 0, bottom = 0;

  explicit PixelBox(const PixelPolygon& polygon) {
    if (polygon.empty()) return;
    left = right = polygon[0].x;
    top = bottom = polygon[0].y;
    for (const Pixel& p : polygon) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
  }
  bool meets(const PixelBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// A part of a side of a piece as it would be seen if nothing hid it.
struct SidePart {
  std::uint32_t element = 0;
  PixelPolygon outline;                    // in the picture
  PixelBox box;                            // of the outline
  std::optional<Shade3> shade;             // nothing: one value
  std::array<std::uint32_t, 2> corners{};  // of the mesh
  bool is_all = false;                     // of that side: then there is no outline
};

// The sides of pieces before a camera.
class Sides {
 public:
  Sides(const SeenScene3& scene, const Point3& eye, const Projection3& projection)
      : scene_(scene), eye_(eye), projection_(projection), parts_(2 * scene.prepared.occluders().size()) {
    const auto& parts = scene.table.parts();
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!parts[k].patch.is_sky() && scene.table.has_row(parts[k].label))
        parts_[Face{parts[k].patch.surface, parts[k].is_back}.number()].push_back(k);
    if (scene.mesh == nullptr) return;
    corner_values_ = scene.mesh->at_corners(scene.paint.values, scene.paint.channels);
    for (const Point3& corner : scene.mesh->corners()) ways_.push_back(rounded_way(eye, corner));
  }

  // COST: that of the parts where another face was asked for before; else nothing.
  const std::vector<SidePart>& of(const Face& face) {
    if (face.number() == last_) return side_;
    last_ = face.number();
    side_.clear();
    for (const std::size_t k : parts_[face.number()]) add(k, parts_[face.number()].size() == 1);
    return side_;
  }

 private:
  void add(std::size_t k, bool is_only) {
    const ElementTable3::Part& part = scene_.table.parts()[k];
    const bool is_blended =
        scene_.mesh != nullptr && !scene_.mesh->ring(k).empty() && scene_.paint.has_value(part.label);
    if (is_blended) return add_triangles(k, part.label);
    const bool is_all =
        is_only && scene_.table.is_one_patch(part.label) && scene_.table.elements()[part.label].parts == 1;
    PixelPolygon outline;
    if (!is_all) {
      std::vector<Direction3> corners;
      for (const Point3& p : corners_of(scene_.prepared.occluders().vertices(), part.patch))
        corners.push_back(rounded_way(eye_, p));
      outline = projection_.picture(std::move(corners));
      if (outline.size() < 3) return;
    }
    const PixelBox box(outline);
    side_.push_back({part.label, std::move(outline), box, std::nullopt, {}, is_all});
  }

  // From the middle of a part to each of its sides.
  void add_triangles(std::size_t k, std::uint32_t element) {
    const std::span<const std::uint32_t> ring = scene_.mesh->ring(k);
    const Direction3 middle = middle_of(scene_.table.parts()[k].patch);
    const auto value = [&](std::uint32_t corner) {
      return std::span<const double>(corner_values_).subspan(corner * scene_.paint.channels, scene_.paint.channels);
    };
    for (std::size_t c = 0; c < ring.size(); ++c) {
      const std::uint32_t a = ring[c], b = ring[c + 1 == ring.size() ? 0 : c + 1];
      PixelPolygon outline = projection_.picture({middle, ways_[a], ways_[b]});
      if (outline.size() < 3) continue;
      const PixelBox box(outline);
      side_.push_back(
          {element,
           std::move(outline),
           box,
           Shade3(projection_, {middle, ways_[a], ways_[b]}, {scene_.paint.value(element), value(a), value(b)}),
           {a, b},
           false});
    }
  }

  // The way to the mean of its own corners: those within its sides do not move it.
  Direction3 middle_of(const Patch3& patch) const {
    Direction3 sum;
    const auto corners = corners_of(scene_.prepared.occluders().vertices(), patch);
    for (const Point3& corner : corners) sum = sum + rounded_way(eye_, corner);
    return (1.0 / static_cast<double>(corners.size())) * sum;
  }

  const SeenScene3& scene_;
  const Point3& eye_;
  const Projection3& projection_;
  std::vector<std::vector<std::size_t>> parts_;  // of the table, by side of a piece
  std::vector<double> corner_values_;            // by corner of the mesh and channel
  std::vector<Direction3> ways_;                 // by corner of the mesh
  static constexpr std::uint32_t kNoFace = 0xffffffff;
  std::uint32_t last_ = kNoFace;  // the number of the face asked for last
  std::vector<SidePart> side_;
};

}  // namespace

Shade3::Shade3(const Projection3& projection, const std::array<Direction3, 3>& ways,
               const std::array<std::span<const double>, 3>& values)
    : channels_(values[0].size()) {
  HOTTEL_REQUIRE(channels_ <= kMostChannels);
  for (std::size_t k = 0; k < 3; ++k) {
    const double sign = dot(ways[k], cross(ways[(k + 1) % 3], ways[(k + 2) % 3])) < 0 ? -1 : 1;
    add(projection.dot_with(cross(ways[(k + 1) % 3], ways[(k + 2) % 3])), sign, share_[k]);
    add(share_[k], 1, under_);
  }
  set(values);
}

void Shade3::set(const std::array<std::span<const double>, 3>& values) {
  over_ = {};
  for (std::size_t k = 0; k < 3; ++k) {
    HOTTEL_REQUIRE(values[k].size() == channels_);
    std::copy(values[k].begin(), values[k].end(), corners_[k].begin());
    for (std::size_t c = 0; c < channels_; ++c) add(share_[k], values[k][c], over_[c]);
  }
  for (std::size_t c = 0; c < channels_; ++c)
    std::tie(low_[c], high_[c]) = std::minmax({corners_[0][c], corners_[1][c], corners_[2][c]});
}

void Shade3::value(const Pixel& at, std::span<double> result) const {
  const double under = under_.at(at);
  for (std::size_t c = 0; c < channels_; ++c) {
    const double blended = over_[c].at(at) / under;
    result[c] = std::isfinite(blended) ? std::clamp(blended, low_[c], high_[c]) : corners_[0][c];
  }
}

AffineValue3 Shade3::above(std::span<const double> weights, double level) const {
  AffineValue3 result;
  for (std::size_t c = 0; c < weights.size(); ++c) add(over_[c], weights[c], result);
  add(under_, -level, result);
  return result;
}

double Shade3::low(std::span<const double> weights) const {
  return std::min({weighted(weights, corners_[0]), weighted(weights, corners_[1]), weighted(weights, corners_[2])});
}

double Shade3::high(std::span<const double> weights) const {
  return std::max({weighted(weights, corners_[0]), weighted(weights, corners_[1]), weighted(weights, corners_[2])});
}

void for_each_seen_part(const SeenScene3& scene, const Camera3& camera,
                        const std::function<void(const SeenPart3&)>& take) {
  const PreparedScene3& prepared = scene.prepared;
  const VisibilityMap3 map = eye_map_3(prepared, camera);
  const Projection3 projection(camera);
  Sides sides(scene, camera.eye, projection);
  for (const VisibilityMap3::Fragment& fragment : map.fragments) {  // those of a face follow each other
    throw_if_interrupted();
    std::vector<Direction3> corners;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) corners.push_back(map.corners[c].direction);
    PixelPolygon seen = projection.picture(std::move(corners));
    if (seen.size() < 3) continue;
    const std::vector<SidePart>& parts = sides.of(fragment.face);
    if (parts.empty()) take({std::move(seen), std::nullopt, nullptr, {}});
    const PixelBox box(seen);
    for (const SidePart& part : parts) {
      if (!part.is_all && !part.box.meets(box)) continue;
      PixelPolygon polygon = part.is_all ? seen : common_polygon_3(seen, part.outline);
      if (polygon.size() > 2)
        take({std::move(polygon), part.element, part.shade ? &*part.shade : nullptr, part.corners});
    }
  }
}

}  // namespace hottel
