// A polygon of space, and whether it is one.
#pragma once

#include <string>
#include <vector>

#include "geometry/space/point.h"

namespace hottel {

// A plane convex polygon. Its front is the side from which its points go around counter-clockwise.
struct Polygon3 {
  std::vector<Point3> points;  // the last is joined to the first
  friend bool operator==(const Polygon3&, const Polygon3&) = default;
};

// Why points are no polygon: the end of a sentence ("is not convex: ..."), and what helps. Both are empty where they
// are one.
struct PolygonProblem3 {
  std::string text, hint;
};

// Returns what is wrong with a polygon, by exact arithmetic: there is no tolerance.
//
//   (1) it has at least three points, in lowest terms, no two of them equal, and not all on one line
//   (2) all lie in one plane; otherwise it is told how far they are off the plane of three of them that lie far apart
//   (3) it is convex and goes around once: it turns to one side only, or goes straight on, and never back
//
// COST: n log n for n points.
PolygonProblem3 polygon_problem(const Polygon3& polygon);

// Returns the normal on the front whose length is twice the area, exactly: the sum of the vector products of its points
// in turn, taken from the first.
//
//   (1) the opposite for the points in opposite order; the same wherever the order begins
//   (2) not zero for a polygon without a problem
Vector3 doubled_area(const Polygon3& polygon);

}  // namespace hottel
