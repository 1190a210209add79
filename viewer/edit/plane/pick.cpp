#include "viewer/edit/plane/pick.h"

#include <algorithm>
#include <cmath>

#include "kernel/exact_double.h"

namespace hottel {
namespace {

constexpr double kSameDistance = 1e-6;  // as a part of the reach

double squared_length(double x, double y) { return x * x + y * y; }

// Above 0 on the left of the edge.
double side_of(const LocalEdge2& e, const Place2& p) {
  return (e.to_x - e.from_x) * (p[1] - e.from_y) - (e.to_y - e.from_y) * (p[0] - e.from_x);
}

bool is_at_back(const Edge2& e, const Place2& place) {
  const Rational x = exact_value(place[0]), y = exact_value(place[1]);
  return (e.to.x - e.from.x) * (y - e.from.y) > (e.to.y - e.from.y) * (x - e.from.x);
}

}  // namespace

std::optional<std::uint32_t> ScenePick2::edge_at(const Place2& local, double reach) const {
  // The back of a patch without one is that of what it lies on.
  const auto is_there = [&](std::uint32_t s) {
    return !patches_.is_patch(s) || scene_->surfaces[s].back || side_of(local_.edges()[s], local) <= 0;
  };
  std::optional<std::uint32_t> nearest;
  double least = reach;
  for (std::uint32_t s = 0; s < local_.edges().size(); ++s) {
    const double distance = local_foot(local_.edges()[s], local).distance;
    if (!(nearest ? distance < least : distance <= least) || !is_there(s)) continue;
    least = distance;
    nearest = s;
  }
  if (!nearest) return nearest;
  const auto is_as_near = [&](std::uint32_t s) {
    return is_there(s) && local_foot(local_.edges()[s], local).distance <= least + kSameDistance * reach;
  };
  if (const auto patch = innermost_patch(is_as_near)) return patch;
  if (side_of(local_.edges()[*nearest], local) <= 0) return nearest;
  for (std::uint32_t s = 0; s < local_.edges().size(); ++s)
    if (side_of(local_.edges()[s], local) <= 0 && is_as_near(s)) return s;
  return nearest;
}

std::optional<std::uint32_t> ScenePick2::innermost_patch(const std::function<bool(std::uint32_t)>& is_there) const {
  std::optional<std::uint32_t> innermost;
  for (std::uint32_t s = 0; s < local_.edges().size() && !patches_.is_empty(); ++s)
    if (patches_.is_patch(s) && (!innermost || patches_.rests_on(s, *innermost)) && is_there(s)) innermost = s;
  return innermost;
}

Pick2 ScenePick2::at(const Place2& place, double reach) const {
  const Place2 local = local_.to_local(place);
  const double local_reach = local_.to_local(reach);
  Pick2 pick;
  double least = local_reach * local_reach;
  for (std::uint32_t s = 0; s < local_.edges().size(); ++s) {
    const LocalEdge2& e = local_.edges()[s];
    const double from = squared_length(e.from_x - local[0], e.from_y - local[1]),
                 to = squared_length(e.to_x - local[0], e.to_y - local[1]), nearer = std::min(from, to);
    if (!(pick.vertex ? nearer < least : nearer <= least)) continue;
    least = nearer;
    pick.vertex = from <= to ? scene_->edges[s].from : scene_->edges[s].to;
  }
  if (pick.vertex) pick.vertex_distance = local_.from_local(std::sqrt(least));
  pick.surface = edge_at(local, local_reach);
  if (!pick.surface) return pick;
  const auto [t, distance] = local_foot(local_.edges()[*pick.surface], local);
  pick.face = {*pick.surface, is_at_back(scene_->edges[*pick.surface], place)};
  pick.is_last = t > 0.5;
  pick.t = t;
  pick.distance = local_.from_local(distance);
  return pick;
}

std::vector<std::uint32_t> ScenePick2::in_rectangle(const Place2& corner, const Place2& opposite) const {
  const Place2 a = local_.to_local(corner), b = local_.to_local(opposite);
  const auto is_inside = [&](double x, double y) {
    return std::min(a[0], b[0]) <= x && x <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= y &&
           y <= std::max(a[1], b[1]);
  };
  std::vector<std::uint32_t> inside;
  for (std::uint32_t s = 0; s < local_.edges().size(); ++s) {
    const LocalEdge2& e = local_.edges()[s];
    if (is_inside(e.from_x, e.from_y) && is_inside(e.to_x, e.to_y)) inside.push_back(s);
  }
  return inside;
}

}  // namespace hottel
