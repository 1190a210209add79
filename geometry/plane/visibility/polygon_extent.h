// How large the regions are that points see.
#pragma once

#include <optional>

#include "geometry/plane/visibility/rounded_polygon.h"

namespace hottel {

// The area and the perimeter of a region.                                [unit: scene length, and its square]
struct PolygonExtent2 {
  double area = 0, perimeter = 0;
};

// Returns those of what a point sees, by its corners in doubles: sides are straight, arcs (kRange) are arcs of the
// radius `range` about the eye. Nothing where the sky is seen, and in a solid. Each is good to some 1e-15, relative.
//
// REQUIRES the polygon of this eye within this range, if there is one. COST: some ns a corner.
std::optional<PolygonExtent2> extent_of(const Point2& eye, const RoundedPolygon2& polygon,
                                        const std::optional<Rational>& range = {});

// Returns the area exactly, of exact corners. Nothing where the sky is seen, and in a solid. REQUIRES
// RoundedPolygon2::exact.
std::optional<Rational> exact_area_of(const RoundedPolygon2& polygon);

}  // namespace hottel
