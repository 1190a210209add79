// Closed lines that are nearly, but not exactly, in one plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

// How far points are from being in one plane: off that of the triangle of three of them that has the largest area, the
// first such triangle where there are several.
struct Bend3 {
  Rational squared_distance;  // of the farthest; 0 iff all points lie in one plane
  Rational squared_diameter;  // the largest distance of two points
  Point3 farthest;
};

// The largest distance of two points, squared. COST: quadratic.
Rational squared_diameter(const std::vector<Point3>& points);

// Do all points lie in one plane?
bool are_in_one_plane(const std::vector<Point3>& points);

// COST: linear where all points lie in one plane; else cubic, a microsecond for some hundred triangles.
Bend3 bend_of(const std::vector<Point3>& points);

// The normal of a loop whose length is twice its area: that of the triangles of a fan, summed up.
Vector3 doubled_loop_area(const std::vector<Point3>& loop);

// Returns triangles in place of a loop and holes in it that do not lie in one plane, by the numbers of their points:
// those of the first loop, then those of the others. None where the loops cross or touch themselves or each other as
// seen along the axis of the largest component of the first one's area.
//
//   (1) each side of a loop is a side of one triangle, and triangles that share another side are on both sides of it
//   (2) seen along that axis they go around as the first loop does and share no area
//   (3) of a single loop that is convex, seen so, all have its first point, in the order of the points; else they are
//       the constrained Delaunay triangulation of what is seen
//
// REQUIRES loops of three points or more. COST: some 20 microseconds a point.
std::vector<std::array<std::uint32_t, 3>> triangles_of_loops(const std::vector<std::vector<Point3>>& loops);

}  // namespace hottel
