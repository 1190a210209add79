// What two points on diffuse edges exchange in the plane.
#pragma once

#include "solver/plane/methods/element_geometry.h"

namespace hottel {

// Returns cos cos' / (2 r) for points x, y with unit normals, r their distance and the cosines those of the angles
// between the segment and the normals; 0 when one of them is not positive. [1 / local unit]
// S(a, b) is the integral of this over the points of a and of b that see each other.
//
//   (1) symmetric in the two points, bit for bit, and never below 0
//   (2) 0 for points that coincide
inline double cosine_kernel(const LocalPoint2& x, const LocalVector2& x_normal, const LocalPoint2& y,
                            const LocalVector2& y_normal) {
  const LocalVector2 d = y - x;
  const double from = dot(x_normal, d), to = -dot(y_normal, d);
  if (!(from > 0 && to > 0)) return 0;
  const double r = length(d);
  return r > 0 ? (from / r) * (to / r) / (2 * r) : 0;
}

// The same between the middles of two runs: what the midpoint rule takes for all their points.
inline double between_centres(const ElementRun2& a, const ElementRun2& b) {
  return cosine_kernel(a.centre, a.normal(), b.centre, b.normal());
}

// And cos cos' / r^2 between them. [1 / local unit^2]
inline double inverse_square(const ElementRun2& a, const ElementRun2& b) {
  const double kernel = between_centres(a, b);
  return kernel > 0 ? 2 * kernel / length(b.centre - a.centre) : 0;
}

// The mean of the cosine kernel over the four pairs of ends that are not nearer than `nearest`.
inline double mean_over_ends(const ElementRun2& a, const ElementRun2& b, double nearest) {
  double sum = 0;
  for (const LocalPoint2* const x : {&a.from, &a.to})
    for (const LocalPoint2* const y : {&b.from, &b.to})
      if (!(length(*y - *x) < nearest)) sum += cosine_kernel(*x, a.normal(), *y, b.normal());
  return sum / 4;
}

}  // namespace hottel
