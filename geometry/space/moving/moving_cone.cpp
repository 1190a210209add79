#include "geometry/space/moving/moving_cone.h"

#include <algorithm>

#include "geometry/space/visibility/cone_split.h"

namespace hottel {

void MovingCutter3::set_cone(std::uint32_t body, int facing, bool is_antipodal, Cone& cone) const {
  cone.is_antipodal = is_antipodal;
  planes_.cone_sides(body, facing, is_antipodal, cone.sides);
  cone.corners = planes_.bodies().bodies[body].corners;
}

// The outline is made of the edges at which one face is seen from outside and the other one is not.
void MovingCutter3::set_cone(const PairGeometry3::Solid& solid, std::span<const signed char> facings, bool is_antipodal,
                             Cone& cone) const {
  cone.is_antipodal = is_antipodal;
  cone.sides.clear();
  cone.corners.clear();
  const auto is_seen = [&](std::uint32_t face) {
    return face != PairGeometry3::Solid::kNone && facings[face] * solid.outward[face] > 0;
  };
  for (const PairGeometry3::Solid::Edge& edge : solid.edges) {
    const bool is_first = is_seen(edge.face[0]);
    if (is_first == is_seen(edge.face[1])) continue;
    const std::uint32_t face = edge.face[is_first ? 0 : 1], side = edge.side[is_first ? 0 : 1];
    cone.sides.push_back(planes_.cone_side(solid.faces[face], side, facings[face], is_antipodal));
    const std::vector<std::uint32_t>& corners = planes_.bodies().bodies[solid.faces[face]].corners;
    for (const std::uint32_t corner : {corners[side], corners[side + 1 == corners.size() ? 0 : side + 1]})
      if (std::ranges::find(cone.corners, corner) == cone.corners.end()) cone.corners.push_back(corner);
  }
}

// As JoinedBodies3 says: each body is seen from its side, and the outline turns left at each corner.
bool MovingCutter3::set_cone(const JoinedBodies3::Group& group, bool is_antipodal, Cone& cone) {
  cone.is_antipodal = is_antipodal;
  cone.sides.clear();
  cone.corners.clear();
  for (std::size_t k = 0; k < group.bodies.size(); ++k)
    if (planes_.facing(group.bodies[k]) != group.facings[k]) return false;
  for (std::size_t k = 0; k < group.outline.size(); ++k) {
    const JoinedBodies3::Side& side = group.outline[k];
    const JoinedBodies3::Side& next = group.outline[k + 1 == group.outline.size() ? 0 : k + 1];
    // Passed as its corners run where its back is seen.
    const bool is_back = planes_.bodies().bodies[side.body].corners[side.side] == side.from;
    const PlaneSide3 inside = planes_.cone_side(side.body, side.side, is_back ? -1 : 1, false);
    const std::span<const std::uint32_t> corner{&next.to, 1};
    if (!planes_.is_any_positive(corner, inside)) return false;
    planes_.rely(corner, inside);
    cone.sides.push_back(is_antipodal ? inside.opposite() : inside);
    cone.corners.push_back(side.from);
  }
  return true;
}

void MovingCutter3::set_fragment(const Cone& cone, int facing, MovingFragment3& fragment) const {
  const std::vector<std::uint32_t>& corners = cone.corners;
  const std::size_t count = corners.size();
  fragment.clear();
  for (std::size_t k = 0; k < count; ++k) {
    // Side k of the cone begins at corner k, or, where the order is turned, at the one that follows it in the list.
    const std::size_t at = facing < 0 ? k : (2 * count - k) % count;
    fragment.push_back(planes_.corner_at(corners[at], cone.is_antipodal, cone.sides[k]));
  }
}

MovingCutter3::Extremes MovingCutter3::find_signs(const MovingFragment3& fragment, PlaneSide3 side) {
  Extremes result;
  planes_.find_signs(fragment, side, signs_);
  for (const signed char sign : signs_) {
    result.has_positive |= sign > 0;
    result.has_negative |= sign < 0;
  }
  return result;
}

MovingCutter3::Cut MovingCutter3::clip(MovingFragment3& fragment, PlaneSide3 side) {
  const Extremes extremes = find_signs(fragment, side);
  if (!extremes.has_positive) return Cut::kAll;
  if (!extremes.has_negative) return Cut::kNothing;
  split_cone(planes_, fragment, signs_, side, &next_, static_cast<MovingFragment3*>(nullptr));
  std::swap(fragment, next_);
  return Cut::kPart;
}

// Whether one of the planes does: first those of the cone, then those of the fragment.
bool MovingCutter3::separates(const MovingFragment3& fragment, const Cone& cone, std::uint32_t place) {
  if (place < cone.sides.size()) return planes_.rely_if_none_is_positive(fragment, cone.sides[place]);
  const PlaneSide3 plane = fragment[place - cone.sides.size()].plane;
  return planes_.rely_if_none_is_positive(cone.corners, cone.is_antipodal ? plane.opposite() : plane);
}

bool MovingCutter3::is_apart(const MovingFragment3& fragment, const Cone& cone, std::uint32_t& hint) {
  const auto count = static_cast<std::uint32_t>(cone.sides.size() + fragment.size());
  const std::uint32_t first = hint < count ? hint : 0;
  if (separates(fragment, cone, first)) return true;
  for (std::uint32_t place = 0; place < count; ++place)
    if (place != first && separates(fragment, cone, place)) {
      hint = place;
      return true;
    }
  return false;
}

bool MovingCutter3::subtract(MovingFragment3& fragment, std::span<const PlaneSide3> sides, MovingFragments3& rest) {
  const std::size_t before = rest.size();
  const MovingFragment3* inside = &fragment;
  for (const PlaneSide3 side : sides) {
    const Extremes extremes = find_signs(*inside, side);
    if (!extremes.has_negative) continue;
    if (!extremes.has_positive) {
      rest.resize_down(before);
      std::swap(rest.add(), fragment);
      return false;
    }
    split_cone(planes_, *inside, signs_, side, &next_, &rest.add());
    std::swap(current_, next_);
    inside = &current_;
  }
  return true;
}

}  // namespace hottel
