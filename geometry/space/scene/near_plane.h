// Polygons that are plane but for the digits in which they were written.
#pragma once

#include "geometry/space/scene/polygon.h"

namespace hottel {

// The spacing of binary floating-point numbers with this many digits (24 of floats, 53 of doubles) at the largest
// coordinate of a polygon.
Rational float_spacing(const Polygon3& polygon, int digits);

// Sets is_nearly_plane, without facets of its own, and returns it: true iff the points do not lie in one plane, and lie
// off that of their largest triangle (bend_of) by no more than the planarity tolerance (is_within_planarity); and can
// be cut into triangles. `unit` is what the last digit of the coordinates stands for, 0 where they have none.
//
// COST: linear for a polygon that is plane; else that of bend_of and triangles_of_loops.
bool accept_nearly_plane(Polygon3& polygon, const Rational& unit);

}  // namespace hottel
