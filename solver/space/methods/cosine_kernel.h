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

}  // namespace hottel
