#include "geometry/space/arrangement/edge_components.h"

#include <algorithm>
#include <utility>

namespace hottel {

EdgeComponents3::EdgeComponents3(const Occluders3& occluders) : of_edge_(occluders.edge_count()) {
  constexpr std::uint32_t kNone = 0xffffffff;
  of_polygon_.assign(occluders.size(), kNone);
  for (std::uint32_t s = 0; s < occluders.size(); ++s)
    for (const DirectedEdge3& side : occluders.edges(s)) of_edge_[side.edge.index()].push_back(s);
  for (std::uint32_t s = 0; s < occluders.size(); ++s) {
    if (of_polygon_[s] != kNone) continue;
    const auto number = static_cast<std::uint32_t>(all_.size());
    std::vector<std::uint32_t>& all = all_.emplace_back(1, s);
    of_polygon_[s] = number;
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const DirectedEdge3& side : occluders.edges(all[k]))
        for (const std::uint32_t next : of_edge(side.edge))
          if (std::exchange(of_polygon_[next], number) == kNone) all.push_back(next);
    std::ranges::sort(all);
  }
}

}  // namespace hottel
