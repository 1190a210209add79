// What convex polygons of one plane look like when they are joined.
#pragma once

#include <vector>

#include "geometry/space/scene/flat_region.h"

namespace hottel {

// A connected part of a region: its outline goes around counter-clockwise, its holes clockwise.
struct FlatPart3 {
  std::vector<FlatPoint3> outline;
  std::vector<std::vector<FlatPoint3>> holes;
};

// Returns the parts of the region that polygons make together.
//
//   (1) no loop has a point in the middle of a side, and sides where two polygons meet are gone, also where a corner of
//       one lies within a side of the other
//   (2) what meets in points alone are parts of their own; a loop passes no point twice but where a part touches itself
//       in a corner
//   (3) the areas of the outlines, less those of the holes, are those of the polygons
//
// REQUIRES convex polygons, each counter-clockwise, that share no area. COST: n log n for n sides, and the square of
// the number of loops.
std::vector<FlatPart3> joined_outline(const std::vector<std::vector<FlatPoint3>>& polygons);

}  // namespace hottel
