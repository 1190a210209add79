#include "viewer/picture/space/grown_polygon.h"

#include <algorithm>
#include <tuple>

namespace hottel {

PixelPolygon grown_polygon_3(const PixelPolygon& polygon, double half_side) {
  PixelPolygon points;
  for (const Pixel& p : polygon)
    for (const double dx : {-half_side, half_side})
      for (const double dy : {-half_side, half_side}) points.push_back({p.x + dx, p.y + dy});
  std::sort(points.begin(), points.end(),
            [](const Pixel& a, const Pixel& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  // The lower border from left to right, then the upper one back (Andrew's monotone chain).
  PixelPolygon hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t kept = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= kept + 2) {
        const Pixel &a = hull[hull.size() - 2], &b = hull.back();
        if ((b.x - a.x) * (p->y - a.y) - (b.y - a.y) * (p->x - a.x) > 0) break;
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace hottel
