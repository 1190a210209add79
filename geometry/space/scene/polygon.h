// A polygon of space, and whether it is one.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

// A plane polygon, perhaps with holes. Its front is the side from which its points go around counter-clockwise.
struct Polygon3 {
  std::vector<Point3> points = {};              // the last is joined to the first
  std::vector<std::vector<Point3>> holes = {};  // each in any sense
  // Its points are not in one plane, but so nearly that it stands for its triangles (facets_of): they have its name,
  // its row and its area together, and each its own plane. Readers set it where points are off a plane only by the
  // rounding of their last digits. Who sets it answers for the distance: it is not measured again.
  bool is_nearly_plane = false;
  // Of a patch across bends of what it lies on: the triangles that it stands for (draped). Else none, for it has those
  // of triangles_of_loops.
  std::vector<std::array<Point3, 3>> facets = {};
  friend bool operator==(const Polygon3&, const Polygon3&) = default;
};

// Why points are no polygon: the end of a sentence ("is not convex: ..."), and what helps. Both are empty where they
// are one.
struct PolygonProblem3 {
  std::string text, hint;
};

// Returns what is wrong with a polygon, by exact arithmetic: there is no tolerance.
//
//   (1) outline and holes have at least three points each, in lowest terms, no two equal in one of them, and not all
//       on one line
//   (2) all lie in one plane; otherwise it is told how far they are off it (bend_of). Of one that is nearly plane it is
//       asked instead that it can be cut into triangles (triangles_of_loops), and not (3) and (4)
//   (3) no two sides cross, and none goes back along the one before; outline and holes may touch
//   (4) holes lie in the outline and share no area
//
// COST: n log n for n points of a convex polygon; else that of a PlaneTriangulation3.
PolygonProblem3 polygon_problem(const Polygon3& polygon);

// True iff it is plane, has no hole and turns to one side only, or goes straight on. REQUIRES a polygon without a
// problem.
bool is_convex(const Polygon3& polygon);

// Returns all points of a polygon: those of its outline, then those of its holes.
std::vector<Point3> corners_of(const Polygon3& polygon);

// Returns the outline, then the holes.
std::vector<std::vector<Point3>> loops_of(const Polygon3& polygon);

// Returns the triangles that a nearly plane polygon stands for, or the polygon itself.
//
//   (1) those it has (Polygon3::facets), else those of triangles_of_loops, in their order: what each is the first of
//       stays so
//
// REQUIRES a polygon without a problem.
std::vector<Polygon3> facets_of(const Polygon3& polygon);

// Returns the normal on the front whose length is twice the area, exactly, holes taken away. Of a nearly plane polygon:
// that of its facets, summed up.
//
//   (1) the opposite for the points in opposite order; the same wherever the order begins
//   (2) not zero for a polygon without a problem
Vector3 doubled_area(const Polygon3& polygon);

// A side of a polygon, from a corner to the next one.
struct Side3 {
  Point3 from, to;
  friend bool operator==(const Side3&, const Side3&) = default;
};

// All sides of a polygon, in order: those of its outline, then those of its holes.
//
//   (1) seen from its front the polygon lies on the left of each, whatever the sense in which holes are listed
std::vector<Side3> sides_of(const Polygon3& polygon);

// Returns a point for people: "(2, 3/7, 0)", each coordinate by short_text. What is printed of a long coordinate is
// near it, not exact.
std::string place_text(const Point3& point);

// True iff a point lies in the polygon or on its border, that of a hole too: exactly. REQUIRES a polygon without a
// problem.
bool contains(const Polygon3& polygon, const Point3& point);
// The same for a point of which it is known that it lies in the plane, whose normal is not zero.
bool contains_in_plane(const Polygon3& polygon, const Vector3& normal, const Point3& point);

}  // namespace hottel
