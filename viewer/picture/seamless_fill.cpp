#include "viewer/picture/seamless_fill.h"

#include <algorithm>
#include <tuple>

namespace hottel {

namespace {

constexpr double kGrowth = 0.5;  // pixels

}  // namespace

void fill_below(PictureCanvas& canvas, std::span<const ColouredPolygons> fills) {
  std::vector<std::vector<Pixel>> all;
  for (const ColouredPolygons& fill : fills) all.insert(all.end(), fill.polygons.begin(), fill.polygons.end());
  if (all.size() < 2) return;
  canvas.begin_layer();
  for (const ColouredPolygons& fill : fills) {
    std::vector<std::vector<Pixel>> grown;
    for (const std::vector<Pixel>& polygon : fill.polygons) grown.push_back(grown_polygon(polygon, kGrowth));
    canvas.fill_all(Mark::kPaper, grown, fill.colour);
  }
  canvas.end_layer(all);
}

std::vector<Pixel> grown_polygon(std::span<const Pixel> polygon, double half_side) {
  std::vector<Pixel> points;
  for (const Pixel& p : polygon)
    for (const double dx : {-half_side, half_side})
      for (const double dy : {-half_side, half_side}) points.push_back({p.x + dx, p.y + dy});
  std::sort(points.begin(), points.end(),
            [](const Pixel& a, const Pixel& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  // The lower border from left to right, then the upper one back (Andrew's monotone chain).
  std::vector<Pixel> hull;
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
