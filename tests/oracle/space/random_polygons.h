// Made-up scenes of polygons in space, full of contacts.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

// All of these are the same for the same arguments on every platform. Fronts of rooms look inward, those of boxes
// outward.

// The six walls of a box, each of parts x parts rectangles.
std::vector<SpacePolygon> room_of_walls(const SpacePoint& low, const SpacePoint& high, int parts);
// The six faces of a box.
std::vector<SpacePolygon> box(const SpacePoint& low, const SpacePoint& high);

// A room with boxes in the cells of a lattice, cells^3 cells of 4 units, one of `sparsity` of every second of them:
// neighbours meet along edges and in corners, many edges are in line, and boxes stand on the floor without a face of
// their own there. Every face of a box is parts x parts rectangles.
std::vector<SpacePolygon> lattice_room(std::uint64_t seed, int cells, int sparsity, int parts, int wall_parts);

// n triangles that pierce each other, corners on a lattice of size^3 points; no two in one plane.
std::vector<SpacePolygon> piercing_triangles(std::uint64_t seed, int n, long size, long extent);

// The polygons, each point p mapped to scale * p + offset. REQUIRES scale > 0.
std::vector<SpacePolygon> moved(std::vector<SpacePolygon> polygons, const mpq_class& scale, const SpacePoint& offset);

}  // namespace hottel::oracle
