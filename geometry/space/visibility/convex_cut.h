// Convex polygons and cones of directions, cut by lines and planes.
#pragma once

#include <cstddef>
#include <vector>

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

}  // namespace hottel
