// Convex polygons and cones of directions, cut by lines and planes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "geometry/space/visibility/direction.h"

namespace hottel {

// Returns what is left of a convex polygon, or cone, where height(corner) >= 0. between(a, b, t) is the corner on the
// way from a to b, at the part t of it.
template <class Corner, class Height, class Between>
std::vector<Corner> cut_convex(const std::vector<Corner>& corners, const Height& height, const Between& between) {
  std::vector<Corner> kept;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Corner &a = corners[k], &b = corners[k + 1 == corners.size() ? 0 : k + 1];
    const double at_a = height(a), at_b = height(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(between(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

// Returns what a convex polygon has in common with another one; fewer than three corners where that is nothing.
// beside(a, b, p): above 0 where p lies on the side of the other polygon of its side from a to b.
template <class Corner, class Beside, class Between>
std::vector<Corner> common_convex(std::vector<Corner> polygon, const std::vector<Corner>& other, const Beside& beside,
                                  const Between& between) {
  for (std::size_t k = 0; k < other.size() && polygon.size() > 2; ++k) {
    const Corner &a = other[k], &b = other[k + 1 == other.size() ? 0 : k + 1];
    const auto height = [&](const Corner& p) { return beside(a, b, p); };
    if (!std::ranges::all_of(polygon, [&](const Corner& p) { return height(p) >= 0; }))
      polygon = cut_convex(polygon, height, between);
  }
  return polygon;
}

// Returns what a convex cone has in common with that of a polygon; fewer than three corners where that is nothing.
// ways: from the eye to the corners of the polygon, of any length, counter-clockwise for who sees it from its front, as
// the eye does.
inline std::vector<Direction3> common_cone_3(std::vector<Direction3> cone, std::span<const Direction3> ways) {
  for (std::size_t k = 0; k < ways.size() && cone.size() >= 3; ++k) {
    const Direction3 inward = cross(ways[k + 1 == ways.size() ? 0 : k + 1], ways[k]);
    cone = cut_convex(
        cone, [&inward](const Direction3& d) { return dot(d, inward); },
        [](const Direction3& a, const Direction3& b, double t) { return unit(a + t * (b - a)); });
  }
  return cone;
}

}  // namespace hottel
