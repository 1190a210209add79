#include "geometry/plane/check/point_neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/plane/arrangement/meeting_boxes.h"

namespace hottel {
namespace {

// Calls visit(low, high) for boxes that together cover a segment, none much larger than `size` where it runs slantwise.
template <class Visit>
void for_each_box_along(const Vertices2& vertices, const Segment2& segment, double size, const Visit& visit) {
  constexpr double kMostBoxes = 256;
  const auto &p = vertices.approximate(segment.a), &q = vertices.approximate(segment.b);
  const double dx = q.x - p.x, dy = q.y - p.y;
  const double extent = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y)});
  const double error = vertices.approximation_error() + 8 * std::numeric_limits<double>::epsilon() * extent;
  const double wanted = size > 0 ? std::min(std::fabs(dx), std::fabs(dy)) / size : 1;
  const int count = wanted > 1 ? static_cast<int>(std::min(std::ceil(wanted), kMostBoxes)) : 1;
  for (int k = 0; k < count; ++k) {
    const double s = static_cast<double>(k) / count, t = static_cast<double>(k + 1) / count;
    const double x[2] = {std::lerp(p.x, q.x, s), std::lerp(p.x, q.x, t)};
    const double y[2] = {std::lerp(p.y, q.y, s), std::lerp(p.y, q.y, t)};
    visit({std::min(x[0], x[1]) - error, std::min(y[0], y[1]) - error},
          {std::max(x[0], x[1]) + error, std::max(y[0], y[1]) + error});
  }
}

// A box is that large that about as many of them as there are segments cover the plane that the segments lie in.
double box_size(const Vertices2& vertices, std::size_t segments) {
  if (vertices.size() == 0) return 0;
  double low_x = vertices.approximate(VertexId(0)).x, high_x = low_x, low_y = vertices.approximate(VertexId(0)).y,
         high_y = low_y;
  for (const VertexId v : vertices.ids()) {
    const auto& p = vertices.approximate(v);
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
  return std::max(high_x - low_x, high_y - low_y) / std::sqrt(static_cast<double>(segments) + 1);
}

}  // namespace

DistanceBounds2 distance_bounds(const Vertices2& vertices, const Segment2& segment, VertexId v) {
  const auto &a = vertices.approximate(segment.a), &b = vertices.approximate(segment.b), &p = vertices.approximate(v);
  const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double whole = dx * dx + dy * dy;
  const double t = whole > 0 ? std::clamp((dx * px + dy * py) / whole, 0.0, 1.0) : 0;
  const double distance = std::hypot(px - t * dx, py - t * dy);
  // What the point t is wrong by, it is wrong along the segment: far less than this.
  const double rounding =
      64 * std::numeric_limits<double>::epsilon() * (std::fabs(dx) + std::fabs(dy) + std::fabs(px) + std::fabs(py));
  const double error = 4 * vertices.approximation_error() + rounding;
  return {distance - error, distance + error};
}

std::vector<std::vector<std::uint32_t>> segments_near_vertices(const Vertices2& vertices,
                                                               const std::vector<Segment2>& segments,
                                                               const std::vector<double>& reach) {
  const double error = vertices.approximation_error();
  std::vector<NumberedBox2> around, boxes;
  for (const VertexId v : vertices.ids()) {
    const auto& p = vertices.approximate(v);
    const double r = 1.01 * reach[v.index()] + 2 * error;
    around.push_back({{p.x - r, p.y - r}, {p.x + r, p.y + r}, static_cast<std::uint32_t>(v.index())});
  }
  const double size = box_size(vertices, segments.size());
  for (std::uint32_t s = 0; s < segments.size(); ++s)
    for_each_box_along(vertices, segments[s], size, [&](std::array<double, 2> low, std::array<double, 2> high) {
      boxes.push_back({low, high, s});
    });
  std::vector<std::vector<std::uint32_t>> near(vertices.size());
  for_each_meeting(around, boxes, [&](std::uint32_t v, std::uint32_t s) {
    if (!(distance_bounds(vertices, segments[s], VertexId(v)).lower > 1.01 * reach[v])) near[v].push_back(s);
  });
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

}  // namespace hottel
