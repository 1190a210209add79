// The mean light in a rectangle by brute force: all lines through two end points cut it into parts in which the view
// stays the same; each is integrated numerically. Long doubles, no data structure, nothing shared with what it checks.
#pragma once

#include <vector>

namespace hottel::oracle {

// A segment from a to b and what its sides send out. Segments given together have disjoint interiors.
struct LitSegment {
  long double ax, ay, bx, by;
  double left, right;
};

// Returns (1/2 pi) times the integral over all directions of what is seen there.
// REQUIRES that the point is not collinear with two end points.
long double mean_irradiance(const std::vector<LitSegment>& segments, double sky, long double x, long double y);

// Returns the mean of it over a rectangle, with an estimate of the error of the quadrature (the difference from one of
// lower order). COST: grows with the fourth power of the number of segments.
struct MeanLight {
  long double value, doubt;
};
MeanLight mean_light(const std::vector<LitSegment>& segments, double sky, long double x0, long double y0,
                     long double x1, long double y1);

}  // namespace hottel::oracle
