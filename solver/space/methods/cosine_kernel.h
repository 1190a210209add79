// What two points on surfaces exchange.
#pragma once

#include <numbers>

#include "solver/space/methods/element_geometry.h"

namespace hottel {

// cos cos' / (pi r^2) between two points with normals of length 1, each cosine clamped at 0. [1 / square of the unit]
//
//   (1) symmetric in the two points, bit for bit, and never below 0
//   (2) 0 for points that coincide
inline double cosine_kernel(const Vector3d& x, const Vector3d& x_normal, const Vector3d& y, const Vector3d& y_normal) {
  const Vector3d d = y - x;
  const double from = dot(x_normal, d), to = -dot(y_normal, d);
  if (!(from > 0 && to > 0)) return 0;
  const double square_of_r = square(d);
  return square_of_r > 0 ? from * to / square_of_r / (std::numbers::pi * square_of_r) : 0;
}

// The same between the centres of two patches: what the midpoint rule takes for all their points.
inline double between_centres(const ElementPatch3& a, const ElementPatch3& b) {
  return cosine_kernel(a.centre, a.normal, b.centre, b.normal);
}

// F(a, b) as if b were a disk about its centre, seen from the centre of a: area_b cos cos' / (pi r^2 + area_b), which
// stays below 1 however near they are.
// SEE: Wallace, Elmquist, Haines, A ray tracing algorithm for progressive radiosity, 1989.
inline double factor_of_disk(const ElementPatch3& a, const ElementPatch3& b) {
  const Vector3d d = b.centre - a.centre;
  const double from = dot(a.normal, d), to = -dot(b.normal, d), square_of_r = square(d);
  if (!(from > 0 && to > 0)) return 0;
  return b.area * (from * to / square_of_r) / (std::numbers::pi * square_of_r + b.area);
}

// The mean of the cosine kernel over all pairs of corners that are not nearer than `nearest`.
inline double mean_over_corners(const ElementPatch3& a, const ElementPatch3& b, double nearest) {
  double sum = 0;
  for (const Vector3d& x : a.corners)
    for (const Vector3d& y : b.corners)
      if (!(length(y - x) < nearest)) sum += cosine_kernel(x, a.normal, y, b.normal);
  return sum / static_cast<double>(a.corners.size() * b.corners.size());
}

}  // namespace hottel
