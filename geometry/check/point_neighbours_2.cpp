#include "geometry/check/point_neighbours_2.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <numeric>

namespace hottel {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const std::uint32_t*>;

}  // namespace

std::vector<std::vector<std::uint32_t>> segments_near_vertices(const Vertices2& vertices,
                                                               const std::vector<Segment2>& segments,
                                                               const std::vector<double>& reach) {
  const double error = vertices.approximation_error();
  std::vector<std::uint32_t> number(std::max(vertices.size(), segments.size()));
  std::iota(number.begin(), number.end(), 0u);
  std::vector<Box> around, boxes;
  for (VertexId v = 0; v < vertices.size(); ++v) {
    const auto& p = vertices.approximate(v);
    const double r = 1.01 * reach[v] + 2 * error;
    double low[2] = {p.x - r, p.y - r}, high[2] = {p.x + r, p.y + r};
    around.emplace_back(low, high, &number[v]);
  }
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    const auto &p = vertices.approximate(segments[s].a), &q = vertices.approximate(segments[s].b);
    double low[2] = {std::min(p.x, q.x) - error, std::min(p.y, q.y) - error};
    double high[2] = {std::max(p.x, q.x) + error, std::max(p.y, q.y) + error};
    boxes.emplace_back(low, high, &number[s]);
  }
  std::vector<std::vector<std::uint32_t>> near(vertices.size());
  CGAL::box_intersection_d(
      around.begin(), around.end(), boxes.begin(), boxes.end(),
      [&near](const Box& point, const Box& box) { near[*point.handle()].push_back(*box.handle()); });
  for (auto& list : near) std::sort(list.begin(), list.end());
  return near;
}

}  // namespace hottel
