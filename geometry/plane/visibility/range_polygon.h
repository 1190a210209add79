// What a point sees within a distance: its visibility polygon cut by a circle.
#pragma once

#include "geometry/plane/visibility/rounded_polygon.h"
#include "geometry/plane/visibility/visibility_polygon.h"

namespace hottel {

// Returns the part of the region that lies within the distance `range` of the eye, in scene units.
//
//   (1) corners are those of the region within the range, the points where its sides cross the circle, and on the way
//       along a ray the point at that distance; each coordinate is the nearest double
//   (2) a side with `after` == kRange is the arc, counter-clockwise about the eye, from its corner to the next one; no
//       two arcs follow each other
//   (3) no side sees the sky: the part is bounded
//   (4) what only touches the circle from outside does not cut it; a whole disc is one corner, right of the eye
//
// From within a solid there are no corners. Throws ContractViolation unless range > 0.
// COST: rational arithmetic and a ball or two for each corner: some 10 µs.
RoundedPolygon2 polygon_within(const VisibilityPolygon2& polygon, const Rational& range);

}  // namespace hottel
