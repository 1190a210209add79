#include "geometry/plane/scene/scene.h"

#include <algorithm>

namespace hottel {

void Scene2::keep(const std::vector<std::uint32_t>& which) {
  Scene2 kept;
  for (const std::uint32_t s : which) kept.add(surfaces[s], edges[s]);
  surfaces = std::move(kept.surfaces);
  edges = std::move(kept.edges);
}

Point2 point_at(const Edge2& edge, const Rational& t) {
  return {edge.from.x + t * (edge.to.x - edge.from.x), edge.from.y + t * (edge.to.y - edge.from.y)};
}

bool is_convex_room(const Scene2& scene) {
  const std::size_t n = scene.surfaces.size();
  if (n < 3) return false;
  // A clockwise closed chain is convex iff it never turns left and its direction goes around once: the sign of its
  // direction along x then changes twice.
  int changes = 0, last = 0, first = 0;
  bool turns = false;
  for (std::size_t k = 0; k < n; ++k) {
    const Edge2 &edge = scene.edges[k], &next = scene.edges[(k + 1) % n];
    if (scene.surfaces[k].back || !(edge.to == next.from)) return false;
    const Rational dx = edge.to.x - edge.from.x, dy = edge.to.y - edge.from.y;
    const Rational ex = next.to.x - next.from.x, ey = next.to.y - next.from.y;
    const Rational turn = dx * ey - dy * ex;
    if (turn > 0 || (turn == 0 && dx * ex + dy * ey < 0)) return false;
    turns |= turn < 0;
    const int sign = sgn(dx);
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    if (first == 0) first = sign;
    last = sign;
  }
  if (last != first) ++changes;
  return turns && changes == 2;
}

}  // namespace hottel
