// Points and polygons of a repair. Internal to geometry/space/check.
#pragma once

#include <vector>

#include "geometry/space/scene/polygon.h"
#include "geometry/space/scene/polygon_places.h"

namespace hottel {

// Whether its coordinates are so long that shorter ones nearby would do.
bool is_long(const Point3& p);

// Returns a point inside the side next to the foot of p, with few decimals along the side, hardly farther from p than
// the foot.
Point3 short_point_near(const Side3& side, const Point3& p, const ClosestPoint3& closest);

// Returns a point of the plane of the polygon next to the foot of p, with few decimals along two of its sides, hardly
// farther from p than the foot. REQUIRES a polygon with an area. It may lie beside a polygon whose edge is nearer.
//
//   (1) its coordinates are decimals where those of the polygon are: points that are put onto what was put onto
//       something share their denominators
Point3 short_point_near(const Polygon3& polygon, const Point3& p, const ClosestPoint3& closest);

// Returns the ring without points that follow on themselves.
std::vector<Point3> without_repetitions(const std::vector<Point3>& ring);

bool has_area(const Polygon3& polygon);

// Returns the triangles of a fan of a polygon that is nearly plane and convex; none where no corner has one whose
// triangles all face where it does.
std::vector<Polygon3> fan_of(const Polygon3& polygon);

}  // namespace hottel
