// Distances of points, and the point of a segment that is nearest to another point.
#pragma once

#include "geometry/plane/scene/scene.h"

namespace hottel {

inline Rational squared_distance(const Point2& a, const Point2& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  return dx * dx + dy * dy;
}

struct ClosestPoint2 {
  Point2 at;
  int end = -1;      // 0, 1: the first, second point of the segment; -1: inside
  Rational squared;  // distance
};

// Exact. REQUIRES a != b.
inline ClosestPoint2 closest_point(const Point2& a, const Point2& b, const Point2& p) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const Rational along = dx * (p.x - a.x) + dy * (p.y - a.y), whole = dx * dx + dy * dy;
  ClosestPoint2 closest{a, 0, 0};
  if (along >= whole) {
    closest = {b, 1, 0};
  } else if (along > 0) {
    const Rational t = along / whole;
    closest = {{a.x + t * dx, a.y + t * dy}, -1, 0};
  }
  closest.squared = squared_distance(p, closest.at);
  return closest;
}

}  // namespace hottel
