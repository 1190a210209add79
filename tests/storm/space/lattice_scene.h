// Scenes of space on a lattice so small that nearly everything coincides.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::storm {

using Polygons3 = std::vector<oracle::SpacePolygon>;

// A scene by its number: any number gives the same scene on every platform. The pair to measure is polygons 0 and 1.
struct LatticeScene3 {
  std::uint64_t number = 0;
  Polygons3 polygons;
};

// Returns two squares of the lattice {0, ..., 4}^3, opposite to each other or adjacent, or a wall that leans, stands on
// the other one or runs through it; between them one to four triangles, parallelograms and hexagons, at times up to
// eight, that pierce, touch, stand on or continue what is there, and screens of two parts that hide nearly all; or
// boxes that stand, lie side by side or are stacked, without faces where they touch. One scene in four has other
// polygons of it for its pair; one in seven is pressed flat, and one in five is nudged, so that nothing touches any
// more, or hardly. No two polygons share an area of one plane.
LatticeScene3 lattice_scene_3(std::uint64_t number);

// Moves one corner of some triangles, all but polygons 0 and 1, by a power of two from 2^-8 to 2^-67 along some axes,
// and returns how far at most; or leaves all as it is, and returns 0, where nothing moves or the scene is not valid
// then.
double nudge_3(Polygons3& polygons, std::uint64_t chance);

// Is each of the polygons one, and do no two of them share an area of one plane?
bool is_valid_3(const Polygons3& polygons);
// Whether that is so with one more. REQUIRES is_valid_3(polygons).
bool stays_valid_3(const Polygons3& polygons, const oracle::SpacePolygon& added);

}  // namespace hottel::storm
