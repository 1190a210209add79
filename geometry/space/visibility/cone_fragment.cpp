#include "geometry/space/visibility/cone_fragment.h"

#include <algorithm>

#include "geometry/space/visibility/cone_split.h"

namespace hottel {

void cone_sides(const EyePlanes3& planes, std::size_t s, std::vector<PlaneSide3>& result) {
  const auto edges = planes.occluders().edges(s);
  const bool is_front = planes.facing(s) > 0;
  result.clear();
  for (const DirectedEdge3& edge : edges)
    result.push_back({PlaneId3(edge.edge.number()), edge.is_backward != is_front});
  if (is_front) std::reverse(result.begin(), result.end());
}

// The determinant of three corners in order is positive where the eye sees the back: then they are taken as they are,
// else in the opposite order.
void cone_of_polygon(const EyePlanes3& planes, std::size_t s, ConeFragment3& result) {
  const auto corners = planes.occluders().outline(s);
  const auto edges = planes.occluders().edges(s);
  const std::size_t count = corners.size();
  const bool is_front = planes.facing(s) > 0;
  result.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = is_front ? count - 1 - k : k;
    const DirectedEdge3& edge = edges[is_front ? (at + count - 1) % count : at];
    result.push_back(planes.corner_at(corners[at], {PlaneId3(edge.edge.number()), edge.is_backward != is_front}));
  }
}

ConeCutter3::Extremes ConeCutter3::find_signs(const ConeFragment3& fragment, PlaneSide3 side) {
  Extremes result;
  signs_.resize(fragment.size());
  for (std::size_t k = 0; k < fragment.size(); ++k) {
    const int sign = planes_.sign(fragment[k], side);
    signs_[k] = static_cast<signed char>(sign);
    result.has_positive |= sign > 0;
    result.has_negative |= sign < 0;
  }
  return result;
}

bool ConeCutter3::clip(const ConeFragment3& fragment, PlaneSide3 side, ConeFragment3& inside) {
  const Extremes extremes = find_signs(fragment, side);
  if (!extremes.has_positive) return false;
  if (extremes.has_negative)
    split_cone(planes_, fragment, signs_, side, &inside, static_cast<ConeFragment3*>(nullptr));
  else
    inside = fragment;
  return true;
}

bool ConeCutter3::is_inside(const ConeFragment3& fragment, const Direction3& axis, const ConeBounds3& cone) {
  const auto is_beyond = [&axis](const Direction3& m) { return dot(m, axis) < 0; };
  return std::none_of(cone.inward.begin(), cone.inward.end(), is_beyond) &&
         std::all_of(cone.sides.begin(), cone.sides.end(), [this, &fragment](PlaneSide3 side) {
           return std::none_of(fragment.begin(), fragment.end(),
                               [this, side](const ConeCorner3& corner) { return planes_.sign(corner, side) < 0; });
         });
}

// Two convex cones have no common inner point iff the plane of an edge of one of them separates them. A plane that has
// a direction in the fragment on the inner side of the cone, or the other way round, does not.
bool ConeCutter3::is_apart(const ConeFragment3& fragment, const Direction3& axis, const ConeBounds3& cone) {
  for (std::size_t k = 0; k < cone.sides.size(); ++k) {
    if (dot(cone.inward[k], axis) > 0) continue;
    if (std::none_of(fragment.begin(), fragment.end(), [this, side = cone.sides[k]](const ConeCorner3& corner) {
          return planes_.sign(corner, side) > 0;
        }))
      return true;
  }
  return std::any_of(fragment.begin(), fragment.end(), [&](const ConeCorner3& corner) {
    const BoundedVector& m = planes_.normal(corner.plane.plane);
    const double product = m.x * cone.axis.x + m.y * cone.axis.y + m.z * cone.axis.z;
    if ((corner.plane.is_opposite ? -product : product) > 0) return false;
    return std::none_of(cone.corners.begin(), cone.corners.end(),
                        [&](VertexId3 v) { return planes_.sign(v, corner.plane) > 0; });
  });
}

bool ConeCutter3::subtract(const ConeFragment3& fragment, std::span<const PlaneSide3> sides, FragmentList3& rest) {
  const ConeFragment3* current = &fragment;
  const std::size_t before = rest.size();
  for (const PlaneSide3 side : sides) {
    const Extremes extremes = find_signs(*current, side);
    if (!extremes.has_negative) continue;
    if (!extremes.has_positive) {
      rest.add() = *current;
      return rest.size() > before + 1;
    }
    split_cone(planes_, *current, signs_, side, &next_, &rest.add());
    std::swap(current_, next_);
    current = &current_;
  }
  return true;
}

}  // namespace hottel
