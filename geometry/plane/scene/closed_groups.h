// Groups of surfaces that close.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// A group whose surfaces stand together in the list, where each begins at the end of the one before and the last ends
// where the first begins.
struct ClosedGroup2 {
  std::uint32_t group = 0;
  int turn = 0;           // sign of the area it winds around: +1 counter-clockwise (fronts outward), -1 clockwise
  bool has_back = false;  // some surface has a material on its back
};

// Returns the closed groups of a scene, in the order of their surfaces; exact.
//
//   (1) a group of one surface is never closed, nor is one whose surfaces are interrupted by those of another, nor one
//       of patches
//   (2) there and back is closed: turn is 0 then, as wherever the signed area is 0
//
// COST: linear.
std::vector<ClosedGroup2> closed_groups(const Scene2& scene);

}  // namespace hottel
