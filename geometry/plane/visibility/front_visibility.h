// What the fronts at a point of an outline see.
#pragma once

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/visibility/rounded_polygon.h"
#include "geometry/plane/visibility/visibility_polygon.h"

namespace hottel {

// Takes away what the fronts of the pieces at the eye do not see: these parts are no longer free
// (VisibilityPolygon2::Part::solid).
//
//   (1) around the eye the pieces bound sectors. One between two fronts is kept, one between two backs is not; of one
//       between a front and a back what lies before the line of the front is kept
//   (2) fronts are those that own a side; from a point on no piece nothing is taken away
//   (3) `area` tells that of what is left, unless the sky is seen
//
// REQUIRES: a polygon of this arrangement.
void keep_fronts(const Arrangement2& arrangement, VisibilityPolygon2& polygon);

// Returns the polygon with corners in doubles, and if they are wanted exact ones too.
RoundedPolygon2 rounded_polygon(const VisibilityPolygon2& polygon, bool wants_exact);

}  // namespace hottel
