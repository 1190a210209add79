#include "solver/methods/open_space_2.h"

namespace hottel {
namespace {

std::size_t triangle_of(HalfEdgeId h) { return static_cast<std::size_t>(h) / 3; }

// By triangle: whether it is connected to the outside of the convex hull.
std::vector<char> open_triangles(const Triangulation2& triangulation) {
  std::vector<char> is_open(triangulation.triangle_count(), 0);
  std::vector<std::size_t> waiting;
  const auto open = [&](std::size_t triangle) {
    if (is_open[triangle]) return;
    is_open[triangle] = 1;
    waiting.push_back(triangle);
  };
  const auto half_edges = static_cast<HalfEdgeId>(3 * triangulation.triangle_count());
  for (HalfEdgeId h = 0; h < half_edges; ++h)
    if (triangulation.twin(h) < 0 && triangulation.side(h) == kSky) open(triangle_of(h));
  while (!waiting.empty()) {
    const auto first = static_cast<HalfEdgeId>(3 * waiting.back());
    waiting.pop_back();
    for (HalfEdgeId h = first; h < first + 3; ++h)
      if (triangulation.twin(h) >= 0) open(triangle_of(triangulation.twin(h)));
  }
  return is_open;
}

}  // namespace

std::vector<char> borders_open_space(const Arrangement2& arrangement, const Labels2& labels) {
  const Triangulation2& triangulation = arrangement.triangulation();
  const std::vector<char> is_open = open_triangles(triangulation);
  // Sides that no triangle shows lie on the hull and look out of it.
  std::vector<char> side_is_open(arrangement.side_count(), 1);
  const auto half_edges = static_cast<HalfEdgeId>(3 * triangulation.triangle_count());
  for (HalfEdgeId h = 0; h < half_edges; ++h)
    if (triangulation.twin(h) < 0 && triangulation.side(h) != kSky)
      side_is_open[static_cast<std::size_t>(triangulation.side(h))] = is_open[triangle_of(h)];
  std::vector<char> result(labels.count(), 0);
  for (std::size_t side = 0; side < side_is_open.size(); ++side)
    if (side_is_open[side]) result[labels.of(static_cast<PieceSideId>(side))] = 1;
  return result;
}

}  // namespace hottel
