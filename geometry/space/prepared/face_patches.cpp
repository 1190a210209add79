#include "geometry/space/prepared/face_patches.h"

#include <algorithm>
#include <optional>

#include "geometry/space/arrangement/whole_patch.h"

namespace hottel {
namespace {

using Cover = Piece3::Cover;

// A convex polygon, and what others of its plane have in common with it.
class Clipper {
 public:
  explicit Clipper(const std::vector<Point3>& polygon) : frame_(polygon), flat_(frame_.outline(polygon)) {}

  // The front of the result is that of the other polygon. Nothing where that is not in the same plane.
  std::vector<Point3> common(const std::vector<Point3>& other) const {
    std::vector<Point3> result;
    if (std::any_of(other.begin(), other.end(), [this](const Point3& p) { return frame_.height(p) != 0; })) return {};
    for (const FlatPoint3& p : common_part(flat_, frame_.outline(other))) result.push_back(frame_.point(p));
    if (!frame_.is_front_up(other)) std::reverse(result.begin(), result.end());
    return result;
  }

 private:
  PlaneFrame3 frame_;
  std::vector<FlatPoint3> flat_;
};

// Whether a part is more than 15/16 of a whole, by vectors of areas in one plane.
bool is_nearly_all(const Vector3& part, const Vector3& whole) { return 16 * dot(part, whole) > 15 * dot(whole, whole); }

}  // namespace

std::pair<std::vector<IntegerVector>, Integer> integer_points(const Vertices3& vertices,
                                                              std::span<const Point3> points) {
  std::vector<Point3> places;
  Integer weight = 1;
  for (const Point3& point : points) {
    const Point3& p = places.emplace_back(vertices.from_scene(point));
    weight = lcm(weight, lcm(p.x.get_den(), lcm(p.y.get_den(), p.z.get_den())));
  }
  const auto times_weight = [&weight](const Rational& value) {
    return Integer(value.get_num() * (weight / value.get_den()));
  };
  std::vector<IntegerVector> result;
  for (const Point3& p : places) result.push_back({times_weight(p.x), times_weight(p.y), times_weight(p.z)});
  return {std::move(result), std::move(weight)};
}

Patch3 patch_of(const Occluders3& occluders, std::uint32_t piece, const std::vector<Point3>& corners, bool is_back) {
  auto [integers, weight] = integer_points(occluders.vertices(), corners);
  Patch3 patch{.surface = piece, .corners = std::move(integers), .weight = std::move(weight)};
  if (is_back) turn_round(patch);
  return patch;
}

std::vector<Point3> corners_of(const Vertices3& vertices, const Patch3& patch) {
  const Rational unit = vertices.scale() / patch.weight;
  const Point3& origin = vertices.origin();
  std::vector<Point3> corners;
  for (const IntegerVector& c : patch.corners)
    corners.push_back({origin.x + unit * c.x, origin.y + unit * c.y, origin.z + unit * c.z});
  return corners;
}

FacePatches3 face_patches(const Arrangement3& arrangement, const Occluders3& occluders, const Face& face,
                          const std::vector<Point3>* part) {
  FacePatches3 result;
  std::optional<Clipper> clipper;
  if (part != nullptr) clipper.emplace(*part);
  for (const PieceSide3& side : arrangement.sides(face)) {
    const Piece3& piece = arrangement.pieces()[side.piece];
    const Cover cover = piece.side(side.is_back).cover;
    if (cover == Cover::kCovered) continue;
    if (part != nullptr && piece.is_whole && cover == Cover::kFree) {
      result.patches.push_back({patch_of(occluders, side.piece, *part, side.is_back), side.is_back});
      continue;
    }
    const auto of_piece = [&](const std::vector<Point3>& polygon) {
      return clipper ? clipper->common(polygon) : polygon;
    };
    const std::vector<Point3> whole = of_piece(piece.polygon.points);
    if (whole.empty()) continue;
    const SidePatch3 patch{clipper ? patch_of(occluders, side.piece, whole, side.is_back)
                                   : whole_patch(occluders, side.piece, side.is_back),
                           side.is_back};
    if (cover == Cover::kFree) {
      result.patches.push_back(patch);
      if (!result.is_free) result.free.push_back(patch);
      continue;
    }
    std::vector<SidePatch3> free;
    Vector3 rest = doubled_area({whole, {}});
    for (const Polygon3& polygon : piece.side(side.is_back).free)
      if (const auto corners = of_piece(polygon.points); !corners.empty()) {
        free.push_back({patch_of(occluders, side.piece, corners, side.is_back), side.is_back});
        const Vector3 area = doubled_area({corners, {}});
        rest = {rest.x - area.x, rest.y - area.y, rest.z - area.z};
      }
    if (free.empty()) continue;
    if (rest.is_zero()) free.assign(1, patch);  // a part beside what is covered
    if (is_nearly_all(rest, doubled_area({whole, {}}))) {
      result.patches.insert(result.patches.end(), free.begin(), free.end());
      if (!result.is_free) result.free.insert(result.free.end(), free.begin(), free.end());
      continue;
    }
    if (!rest.is_zero() && result.is_free) {
      result.free = result.patches;
      result.is_free = false;
    }
    result.patches.push_back(patch);
    if (!result.is_free) result.free.insert(result.free.end(), free.begin(), free.end());
  }
  return result;
}

}  // namespace hottel
