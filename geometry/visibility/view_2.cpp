#include "geometry/visibility/view_2.h"

namespace hottel {

void look_around(const Vertices2& vertices, const Triangulation2& triangulation, VertexId v, View2& view) {
  view.seen.clear();
  const auto star = triangulation.star(v);
  const auto orientation = [&vertices, v](VertexId j, VertexId k) { return vertices.orientation(v, j, k); };
  for (std::size_t k = 0; k < star.size(); ++k) {
    const StarEntry& entry = star[k];
    view.seen.push_back({entry.neighbour, kSky, entry.left, entry.right});
    if (entry.opposite < 0) continue;
    const VertexId next = star[k + 1 == star.size() ? 0 : k + 1].neighbour;
    expand_cone_through(triangulation, entry.opposite, entry.neighbour, next, orientation, view);
  }
}

}  // namespace hottel
