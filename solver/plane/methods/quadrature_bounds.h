// How far a quadrature of the cosine kernel can be off between two runs that see each other wholly.
#pragma once

#include <optional>

#include "geometry/plane/predicates/vertices.h"
#include "solver/plane/methods/element_geometry.h"

namespace hottel {

// Two runs that lie before each other, as far as error bounds need to know them.
struct FacingRuns2 {
  double length[2];
  double distance;          // a lower bound of the distance between their points
  double largest_distance;  // an upper bound
  // Of the ellipses whose foci are the ends of run k, the smallest that meets the other run: the sum of its axes over
  // the distance of its foci (the parameter rho of a Bernstein ellipse), a lower bound.
  double ellipse[2];
  // Largest distance of the other run from the line of run k, distance of the centre of run k from the line of the
  // other, and the sine of the angle between the two.
  double height[2], centre_height[2], sine;
};

// Nothing unless each run lies before the front of the other or on its line, exactly, and they have no point in common.
std::optional<FacingRuns2> facing_runs(const Vertices2& vertices, const ElementRun2& a, const ElementRun2& b);

// Each returns a bound for |rule - S(a, b)| / (product of the lengths), where the rule takes the mean of the kernel
// over its points on both runs; rounding included.

// One point in the middle of each run.
double midpoint_error(const FacingRuns2& runs);
// The two ends of each run.
double trapezoid_error(const FacingRuns2& runs);
// n Gauss points on each run. REQUIRES n >= 1.
double gauss_error(const FacingRuns2& runs, int n);

}  // namespace hottel
