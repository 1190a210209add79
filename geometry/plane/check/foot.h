// The point of a segment that is nearest to another point.
#pragma once

#include "geometry/plane/check/wording.h"

namespace hottel {

struct Foot2 {
  Point2 at;
  int end = -1;      // 0, 1: the first, second point of the segment; -1: inside
  Rational squared;  // distance
};

// Exact. REQUIRES a != b.
inline Foot2 foot_on(const Point2& a, const Point2& b, const Point2& p) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const Rational along = dx * (p.x - a.x) + dy * (p.y - a.y), whole = dx * dx + dy * dy;
  Foot2 foot{a, 0, 0};
  if (along >= whole) {
    foot = {b, 1, 0};
  } else if (along > 0) {
    const Rational t = along / whole;
    foot = {{a.x + t * dx, a.y + t * dy}, -1, 0};
  }
  foot.squared = squared_distance(p, foot.at);
  return foot;
}

}  // namespace hottel
