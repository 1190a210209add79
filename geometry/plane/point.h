// Points of the plane.
#pragma once

#include <array>

#include "kernel/rational.h"

namespace hottel {

// A point with exact coordinates: of the scene as it was typed, or, where a comment says so, in integer form
// (Vertices2). Two points are equal iff both coordinates are, as numbers.
//
// REQUIRES: both coordinates in lowest terms, as all arithmetic on rationals leaves them.
struct Point2 {
  Rational x, y;
  friend bool operator==(const Point2&, const Point2&) = default;
};

// Returns the doubles nearest to the coordinates.
inline std::array<double, 2> to_doubles(const Point2& point) { return {to_double(point.x), to_double(point.y)}; }

// Points as vectors: the way from q to p, the cross product (positive where q is left of p), the dot product.
inline Point2 minus(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }
inline Rational cross(const Point2& p, const Point2& q) { return p.x * q.y - p.y * q.x; }
inline Rational dot(const Point2& p, const Point2& q) { return p.x * q.x + p.y * q.y; }

// Twice the area of the triangle a b c: positive counter-clockwise, 0 where they are on a line.
inline Rational doubled_area(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace hottel
