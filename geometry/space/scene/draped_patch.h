// Patches that lie across the bends of what they lie on.
#pragma once

#include <optional>
#include <vector>

#include "geometry/space/scene/polygon.h"

namespace hottel {

// Returns a polygon put onto plane polygons that together are all but plane: each point goes along the axis of the
// largest component of the polygon's area, and what is beside them by rounding to the nearest point of their border.
//
//   (1) its facets are triangles, each in the plane of one of those and within it; together they are all of it
//   (2) all corners of these are within the tolerance of patches (is_within_seat, by the larger of the diameters) of
//       one plane, and so is each corner of where it was
//   (3) what lies on them stays, and has the same facets
//
// Nothing where there is no such polygon. `facets` look the same way, or all the other way. `unit`: what the last digit
// of the coordinates stands for, 0 where they have none.
std::optional<Polygon3> draped(const Polygon3& polygon, const std::vector<const Polygon3*>& facets,
                               const Rational& unit);

}  // namespace hottel
