// Where a point lies as a polygon has it: on it, beside it, how far away. Exact, for polygons of any outline.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/space/scene/polygon.h"

namespace hottel {

// The ways of points: p + t v, the squared distance of two points.
Point3 moved(const Point3& p, const Rational& t, const Vector3& v);
Rational squared_distance(const Point3& a, const Point3& b);

// True iff a < b by x, then y, then z.
bool precedes(const Point3& a, const Point3& b);

// The nearest point of something, and which part of it that is.
struct ClosestPoint3 {
  enum class Part : unsigned char { kCorner, kSide, kInside };
  Point3 at;
  Rational squared;  // the distance
  Part part = Part::kInside;
};

// Returns the point of a segment that is nearest to p: kCorner at its ends, else kSide. REQUIRES from != to.
ClosestPoint3 closest_point(const Side3& side, const Point3& p);

// Returns the point of a plane polygon that is nearest to p. COST: linear in its corners.
ClosestPoint3 closest_point(const Polygon3& polygon, const Point3& p);

// Returns the points of two segments that are nearest to each other where both lie inside and the segments are not
// parallel; else nothing: then an end is as near.
std::optional<Side3> closest_insides(const Side3& a, const Side3& b);

// Where a segment that is not in the plane of a polygon meets it; nothing where it does not.
std::optional<Point3> meeting_point(const Polygon3& polygon, const Side3& segment);

// Returns the squared width of a polygon: the least distance of a corner from a side that it does not lie on. It is at
// most the shortest side; of a needle it is little. COST: quadratic in the corners.
//
//   (1) above 0: a hole that touches the outline, or another hole, is no narrow place
Rational squared_width(const Polygon3& polygon);

}  // namespace hottel
