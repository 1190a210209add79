// Polygons that share an area of one plane.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/space/scene/polygon.h"

namespace hottel {

// Returns two polygons of one plane whose interiors have a point in common; nothing where there are none. Exact.
//
//   (1) on whichever side their fronts are; polygons that touch along edges or in points share no area
//   (2) the second of the two is the first one in the list that shares an area with one before it, and the first is the
//       first of those
//
// REQUIRES polygons without a problem (polygon_problem).
// COST: n log n, and a few µs for each pair of one plane whose boxes meet in it; 10^4 tiles of a floor take about
// 0.2 s.
std::optional<std::pair<std::uint32_t, std::uint32_t>> first_overlap(const std::vector<Polygon3>& polygons);

}  // namespace hottel
