#include "solver/plane/light/cells_near.h"

namespace hottel {

Columns2 columns_of(const Vector2 (&corners)[3], double bottom, double top) {
  Columns2 range;
  for (int k = 0; k < 3; ++k) {
    const Vector2 &p = corners[k], &q = corners[(k + 1) % 3];
    const Vector2 &low = p.y < q.y ? p : q, &high = p.y < q.y ? q : p;
    if (high.y < bottom || low.y > top) continue;
    const double left = std::min(low.x, high.x), right = std::max(low.x, high.x);
    if (high.y - low.y <= 0) {
      range.include(left);
      range.include(right);
      continue;
    }
    const double slope = (high.x - low.x) / (high.y - low.y);
    range.include(low.y >= bottom ? low.x : std::clamp(low.x + (bottom - low.y) * slope, left, right));
    range.include(high.y <= top ? high.x : std::clamp(low.x + (top - low.y) * slope, left, right));
  }
  return range;
}

}  // namespace hottel
