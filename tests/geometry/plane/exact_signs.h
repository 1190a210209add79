// The signs of predicates over rationals: slow, obvious, and nothing of the kernel's.
#pragma once

#include "geometry/plane/point.h"

namespace hottel::exact_signs {

// Of the area of the triangle p q r: +1 counter-clockwise.
inline int exact_orientation(const Point2& p, const Point2& q, const Point2& r) {
  const Rational area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return sgn(area);
}

// Of the scalar product (q - p) . (r - p).
inline int exact_direction(const Point2& p, const Point2& q, const Point2& r) {
  const Rational product = (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y);
  return sgn(product);
}

}  // namespace hottel::exact_signs
