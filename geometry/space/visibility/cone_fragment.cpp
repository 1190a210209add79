#include "geometry/space/visibility/cone_fragment.h"

#include <algorithm>

namespace hottel {

void cone_sides(const EyePlanes3& planes, std::size_t s, std::vector<PlaneSide3>& result) {
  const auto edges = planes.blockers().edges(s);
  const bool is_front = planes.facing(s) > 0;
  result.clear();
  for (const DirectedEdge3& edge : edges)
    result.push_back({PlaneId3(edge.edge.number()), edge.is_backward != is_front});
  if (is_front) std::reverse(result.begin(), result.end());
}

// The determinant of three corners in order is positive where the eye sees the back: then they are taken as they are,
// else in the opposite order.
void cone_of_polygon(const EyePlanes3& planes, std::size_t s, ConeFragment3& result) {
  const auto corners = planes.blockers().outline(s);
  const auto edges = planes.blockers().edges(s);
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

// Both signs occur among signs_: the boundary changes sides twice, at a corner or within an edge.
void ConeCutter3::split(const ConeFragment3& fragment, PlaneSide3 side, ConeFragment3* inside, ConeFragment3* outside) {
  const std::size_t count = fragment.size();
  if (inside) inside->clear();
  if (outside) outside->clear();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const int here = signs_[k], there = signs_[next];
    const ConeCorner3& corner = fragment[k];
    if (inside && (here > 0 || (here == 0 && there > 0))) inside->push_back(corner);
    if (outside && (here < 0 || (here == 0 && there < 0))) outside->push_back(corner);
    // Where the plane takes over, its edge begins at the point of change.
    if (here > 0 && there < 0) {
      if (inside) inside->push_back(planes_.corner(corner.plane, side));
      if (outside) {
        ConeCorner3 entry = inside ? inside->back() : planes_.corner(corner.plane, side);
        entry.plane = corner.plane;
        outside->push_back(entry);
      }
    } else if (here < 0 && there > 0) {
      ConeCorner3 change = planes_.corner(side, corner.plane);
      if (inside) inside->push_back(change);
      if (outside) {
        change.plane = side.opposite();
        outside->push_back(change);
      }
    } else if (there == 0 && here != 0) {
      ConeCorner3 change = fragment[next];
      change.plane = here > 0 ? side : side.opposite();
      if (here > 0 && inside) inside->push_back(change);
      if (here < 0 && outside) outside->push_back(change);
    }
  }
}

bool ConeCutter3::clip(const ConeFragment3& fragment, PlaneSide3 side, ConeFragment3& inside) {
  const Extremes extremes = find_signs(fragment, side);
  if (!extremes.has_positive) return false;
  if (extremes.has_negative)
    split(fragment, side, &inside, nullptr);
  else
    inside = fragment;
  return true;
}

bool ConeCutter3::is_inside(const ConeFragment3& fragment, std::span<const PlaneSide3> sides) {
  return std::all_of(sides.begin(), sides.end(), [this, &fragment](PlaneSide3 side) {
    return std::none_of(fragment.begin(), fragment.end(),
                        [this, side](const ConeCorner3& corner) { return planes_.sign(corner, side) < 0; });
  });
}

// Two convex cones have no common inner point iff the plane of an edge of one of them separates them.
bool ConeCutter3::is_apart(const ConeFragment3& fragment, std::size_t s, std::span<const PlaneSide3> sides) {
  const auto is_outside = [this, &fragment](PlaneSide3 side) {
    return std::none_of(fragment.begin(), fragment.end(),
                        [this, side](const ConeCorner3& corner) { return planes_.sign(corner, side) > 0; });
  };
  if (std::any_of(sides.begin(), sides.end(), is_outside)) return true;
  const auto corners = planes_.blockers().outline(s);
  return std::any_of(fragment.begin(), fragment.end(), [this, &corners](const ConeCorner3& corner) {
    return std::none_of(corners.begin(), corners.end(),
                        [this, &corner](VertexId3 v) { return planes_.sign(v, corner.plane) > 0; });
  });
}

void ConeCutter3::subtract(const ConeFragment3& fragment, std::span<const PlaneSide3> sides, FragmentList3& rest) {
  current_ = fragment;
  for (const PlaneSide3 side : sides) {
    const Extremes extremes = find_signs(current_, side);
    if (!extremes.has_negative) continue;
    if (!extremes.has_positive) {
      rest.add() = current_;
      return;
    }
    split(current_, side, &next_, &rest.add());
    std::swap(current_, next_);
  }
}

}  // namespace hottel
