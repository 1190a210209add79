// Polygons cut into what a file of a mesh can hold.
#pragma once

#include <vector>

#include "geometry/space/scene/polygon.h"

namespace hottel {

// Returns triangles that together are the polygon.
//
//   (1) their corners are points of the polygon, and their fronts look to the side of its front
//   (2) none is without area: points in the middle of a side are corners of triangles too
//
// REQUIRES a polygon without a problem. COST: n squared for n points of a convex polygon; else that of
// triangles_of.
std::vector<Polygon3> mesh_triangles(const Polygon3& polygon);

}  // namespace hottel
