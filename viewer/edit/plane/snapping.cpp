#include "viewer/edit/plane/snapping.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane/scene/closest_point.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The nearest so far, within reach.
struct Nearest {
  double distance;
  std::optional<std::uint32_t> surface = {};
  bool is_last = false;

  void offer(double other, std::uint32_t its_surface, bool its_last = false) {
    if (!(surface ? other < distance : other <= distance)) return;
    distance = other;
    surface = its_surface;
    is_last = its_last;
  }
};

double length(double x, double y) { return std::sqrt(x * x + y * y); }

Rational clamped(const Rational& value, const Rational& a, const Rational& b) {
  return std::clamp(value, std::min(a, b), std::max(a, b));
}

}  // namespace

Snap2 Snapper2::at(const Place2& place, const SnapRequest2& request) const {
  const Place2 local = local_.to_local(place);
  std::vector<bool> is_moved(local_.edges().size());
  for (const std::uint32_t s : request.moved) {
    HOTTEL_REQUIRE(s < is_moved.size());
    is_moved[s] = true;
  }
  Nearest vertex{local_.to_local(request.reach)}, edge = vertex;
  for (std::uint32_t s = 0; s < is_moved.size(); ++s) {
    if (is_moved[s]) continue;
    const LocalEdge2& e = local_.edges()[s];
    if (request.to_vertices) {
      vertex.offer(length(e.from_x - local[0], e.from_y - local[1]), s, false);
      vertex.offer(length(e.to_x - local[0], e.to_y - local[1]), s, true);
    }
    if (request.to_edges) edge.offer(local_foot(e, local).distance, s);
  }
  if (vertex.surface) {
    const auto& [from, to] = scene_->edges[*vertex.surface];
    return {vertex.is_last ? to : from, Snap2::To::kVertex, vertex.surface};
  }
  if (edge.surface)
    return {on_edge(scene_->edges[*edge.surface], place, request.decimals), Snap2::To::kEdge, edge.surface};
  return {{rounded_decimal(place[0], request.decimals), rounded_decimal(place[1], request.decimals)}};
}

Point2 Snapper2::on_edge(const Edge2& edge, const Place2& place, int decimals) const {
  const auto& [from, to] = edge;
  const bool is_upright = from.x == to.x, is_level = from.y == to.y;
  if (is_upright || is_level)
    return {is_upright ? from.x : clamped(rounded_decimal(place[0], decimals), from.x, to.x),
            is_level ? from.y : clamped(rounded_decimal(place[1], decimals), from.y, to.y)};
  const Rational wide = abs(to.x - from.x), tall = abs(to.y - from.y);
  const int digits = std::max(1, decimals + decades(std::max(wide, tall)));
  const Rational t = rounded_decimal(position_on(edge, {exact_value(place[0]), exact_value(place[1])}), digits);
  return point_at(edge, clamped(t, 0, 1));
}

Snap2 snapped(const Scene2& scene, const Place2& place, const SnapRequest2& request) {
  return Snapper2(scene).at(place, request);
}

}  // namespace hottel
