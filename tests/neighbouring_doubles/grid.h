// Neighbouring doubles about a degeneracy, and what plain doubles make of them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "tests/geometry/plane/exact_signs.h"

namespace hottel::neighbouring_doubles {

struct Double2 {
  double x, y;
};

inline Point2 exact(const Double2& p) { return {Rational(p.x), Rational(p.y)}; }

// Returns the double `steps` places above a positive one.
inline double next(double value, int steps) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(value) + steps);
}

// A grid of adjacent doubles beside two fixed points, near the line through them.
struct Grid {
  const char* name;
  Double2 corner;
  Double2 q, r;
  int wrong_of_4096;  // signs that plain doubles get wrong among the first 64 x 64

  Double2 at(int i, int j) const { return {next(corner.x, i), next(corner.y, j)}; }
};

inline constexpr int kSide = 256;

// Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples of robustness problems in geometric computations (2008),
// figure 2.
inline const std::vector<Grid>& kettner_grids() {
  static const std::vector<Grid> grids{{"a", {0.5, 0.5}, {12, 12}, {24, 24}, 2164},
                                       {"b", {0.5, 0.5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}, 1600},
                                       {"c",
                                        {0.50000000000002531, 0.5000000000000171},
                                        {17.300000000000001, 17.300000000000001},
                                        {24.00000000000005, 24.0000000000000517765},
                                        2664}};
  return grids;
}

// The predicates as one writes them in doubles, with p as the point that is subtracted.
inline int sign(double value) { return (value > 0) - (value < 0); }
inline int naive_orientation(const Double2& p, const Double2& q, const Double2& r) {
  return sign((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}
inline int naive_direction(const Double2& p, const Double2& q, const Double2& r) {
  return sign((q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y));
}
inline int naive_side_of_circle(const Double2& a, const Double2& b, const Double2& c, const Double2& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  return sign((ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) +
              (cx * cx + cy * cy) * (ax * by - bx * ay));
}

// The same over rationals.
using exact_signs::exact_direction;
using exact_signs::exact_orientation;
inline int exact_side_of_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Rational ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const Rational determinant = (ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) +
                               (cx * cx + cy * cy) * (ax * by - bx * ay);
  return sgn(determinant);
}

}  // namespace hottel::neighbouring_doubles
