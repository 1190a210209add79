#include "solver/plane/methods/quadrature_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

// Every number here is off by some units in the last place of the largest distance; this covers far more.
constexpr double kSlack = 1e-12;

double height_above(const ElementRun2& line, const LocalPoint2& point) { return dot(line.normal(), point - line.from); }

double distance_to_point(const ElementRun2& run, const LocalPoint2& point) {
  const LocalVector2 d = point - run.from;
  const double along = std::clamp(dot(run.direction, d), 0.0, run.length);
  return std::hypot(dot(run.normal(), d), dot(run.direction, d) - along);
}

// Smallest sum of the distances of a point of `run` from the ends of `foci`, which lies on one side of it: the way from
// one end to the other end's mirror image is straight, but must pass through the run; the sum is convex along it.
double smallest_focal_sum(const ElementRun2& run, const ElementRun2& foci) {
  const LocalVector2 from = foci.from - run.from, to = foci.to - run.from;
  const double x0 = dot(run.direction, from), y0 = std::fabs(dot(run.normal(), from));
  const double x1 = dot(run.direction, to), y1 = std::fabs(dot(run.normal(), to));
  const double meets = y0 + y1 > 0 ? x0 + (x1 - x0) * (y0 / (y0 + y1)) : x0;
  const double at = std::clamp(meets, 0.0, run.length);
  return std::hypot(x0 - at, y0) + std::hypot(x1 - at, y1);
}

// Bound for |I - Q| / 2 of Q with n Gauss points over run k = [-1, 1], for any point of the other run, by an ellipse of
// parameter rho on which the kernel is analytic and at most M (Trefethen, Approximation Theory and Approximation
// Practice, 2013, theorem 19.3, with the constant of n points): Chebyshev coefficients are at most 2 M / rho^k, those
// with k < 2 n and odd ones are integrated exactly, the others with an error of at most 2 + 2 / (k^2 - 1).
//
// With the other point y fixed and x at the complex place s of run k the kernel is
//   (height of y above run k) (height of x above the other line) / (2 r^3),
// the first factor constant, the second linear in s, and r^2 = (length / 2)^2 (s - z)(s - conj z), where z is the place
// of y in this frame. For z with parameter R > rho, |s - z| >= (R - rho)(1 - 1 / (rho R)) / 2.
double gauss_error_along(const FacingRuns2& runs, int k, int n, double rho) {
  const double half = runs.length[k] / 2, pole = runs.ellipse[k];
  const double r = half * (pole - rho) * (1 - 1 / (rho * pole)) / 2;
  const double linear = runs.centre_height[k] + half * runs.sine * (rho + 1 / rho) / 2;
  const double largest = runs.height[k] * linear / (2 * r * r * r);
  const double constant = 2 * (2 + 2 / (4.0 * n * n - 1));
  return constant * largest * same_bits::pow(rho, -2 * n) / (1 - 1 / (rho * rho)) / 2;
}

double rounding(const FacingRuns2& runs) {
  // The kernel is at most 1 / (2 distance); its cosines are off by some units of largest_distance over distance, and
  // by what places are off.
  return (0x1p-46 * runs.largest_distance + 0x1p-98) / (runs.distance * runs.distance);
}

}  // namespace

std::optional<FacingRuns2> facing_runs(const Vertices2& vertices, const ElementRun2& a, const ElementRun2& b) {
  for (const auto& [f, g] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const VertexId end : {g->ends.a, g->ends.b})
      if (vertices.orientation(f->ends.a, f->ends.b, end) > 0) return std::nullopt;
  FacingRuns2 runs;
  const ElementRun2* both[] = {&a, &b};
  runs.largest_distance = 0;
  for (const LocalPoint2& x : {a.from, a.to})
    for (const LocalPoint2& y : {b.from, b.to}) runs.largest_distance = std::max(runs.largest_distance, length(y - x));
  const double slack = kSlack * runs.largest_distance;
  runs.distance = std::min({distance_to_point(a, b.from), distance_to_point(a, b.to), distance_to_point(b, a.from),
                            distance_to_point(b, a.to)}) -
                  slack;
  if (!(runs.distance > 0)) return std::nullopt;
  runs.sine = std::min(1.0, std::fabs(a.direction.x * b.direction.y - a.direction.y * b.direction.x) + kSlack);
  for (int k = 0; k < 2; ++k) {
    const ElementRun2 &own = *both[k], &other = *both[1 - k];
    runs.length[k] = own.length;
    runs.height[k] = std::max(height_above(own, other.from), height_above(own, other.to)) + slack;
    runs.centre_height[k] = std::fabs(height_above(other, own.centre)) + slack;
    const double sum = std::max(1.0, (smallest_focal_sum(other, own) - slack) / own.length);
    runs.ellipse[k] = sum + std::sqrt(sum * sum - 1);
  }
  return runs;
}

// With d the vector between the points, a and b unit normals, and the point of a's run moved along the run's direction
// t (so that a t = 0), the kernel is k = (a d)(b d) / (2 r^3) up to the sign, and
//   2 k'' = -6 (a d)(t d)(b t) / r^5 - 3 (a d)(b d) / r^5 + 15 (a d)(b d)(t d)^2 / r^7.
// With (a d, t d) = r (cos, sin) the first term is at most 3 / r^3, the others together at most
// max |cos (15 sin^2 - 3)| / r^3 < 4.14 / r^3: |k''| < 3.6 / distance^3. The midpoint rule is off by length^2 / 24
// times that, along each run; the trapezoid rule by length^2 / 12.
double midpoint_error(const FacingRuns2& runs) {
  const double squares = runs.length[0] * runs.length[0] + runs.length[1] * runs.length[1];
  return 0.15 * squares / (runs.distance * runs.distance * runs.distance) + rounding(runs);
}

double trapezoid_error(const FacingRuns2& runs) { return 2 * midpoint_error(runs); }

double gauss_error(const FacingRuns2& runs, int n) {
  constexpr int kTries = 32;
  double error = 0;
  for (int k = 0; k < 2; ++k) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 1; i < kTries; ++i)
      best = std::min(best, gauss_error_along(runs, k, n, 1 + (runs.ellipse[k] - 1) * i / kTries));
    error += best;
  }
  return error + rounding(runs);
}

}  // namespace hottel
