// Points and polygons of a repair. Internal to geometry/space/check.
#pragma once

#include <vector>

#include "geometry/space/scene/polygon.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {

// True iff a point has coordinates so long that shorter ones nearby would do.
bool is_long(const Point3& p);

// True iff a point has coordinates so long that exact arithmetic with it would take minutes where it takes seconds now:
// a place where planes and edges meet that themselves go through such places. All points of a scene share a
// denominator.
bool is_too_long(const Point3& p);

// Returns a point inside the side near the foot of p, with few decimals along the side. It is hardly farther from p
// than the foot is.
Point3 short_point_near(const Side3& side, const Point3& p, const ClosestPoint3& closest);

// Returns a point of the polygon's plane near the foot of p, with few decimals along two of its sides. It is hardly
// farther from p than the foot is, and may lie outside of the polygon if an edge is nearer. REQUIRES a polygon with an
// area.
//
//   (1) its coordinates are decimals where those of the polygon are: a repair may put points onto a polygon that it has
//       put onto another one, and all share their denominators
Point3 short_point_near(const Polygon3& polygon, const Point3& p, const ClosestPoint3& closest);

// Returns the ring without points that repeat the one before.
std::vector<Point3> without_repetitions(const std::vector<Point3>& ring);

bool has_area(const Polygon3& polygon);

// Returns the triangles of a fan that divides a polygon that is nearly plane and convex. Returns none if from no corner
// all triangles of the fan face the way the polygon does.
std::vector<Polygon3> fan_of(const Polygon3& polygon);

}  // namespace hottel
