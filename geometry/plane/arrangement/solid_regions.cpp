#include "geometry/plane/arrangement/solid_regions.h"

namespace hottel {
namespace {

enum class Edge : unsigned char { kOpen, kWithin, kBorder };

// What an edge of a solid triangle is: no piece, one inside the solid, or one on its border.
Edge kind_of(const Arrangement2& arrangement, HalfEdgeId h) {
  if (arrangement.triangulation().is_open(h)) return Edge::kOpen;
  return arrangement.is_covered(opposite(arrangement.triangulation().side(h))) ? Edge::kWithin : Edge::kBorder;
}

}  // namespace

SolidRegions2::SolidRegions2(const Arrangement2& arrangement) {
  if (arrangement.solids().is_empty()) return;
  const Triangulation2& triangulation = arrangement.triangulation();
  region_.assign(triangulation.triangle_count(), kNone);
  for (const HalfEdgeId h : triangulation.half_edges())
    if (triangulation.is_piece(h) && arrangement.is_covered(triangulation.side(h)) && of(h) == kNone)
      fill(arrangement, triangle_of(h));
  find_borders(arrangement);
}

void SolidRegions2::fill(const Arrangement2& arrangement, TriangleId first) {
  const std::uint32_t region = count();
  borders_.emplace_back();
  std::vector<TriangleId> waiting{first};
  region_[first.index()] = region;
  while (!waiting.empty()) {
    const TriangleId triangle = waiting.back();
    waiting.pop_back();
    for (const HalfEdgeId h : half_edges_of(triangle)) {
      if (kind_of(arrangement, h) == Edge::kBorder) continue;
      const TriangleId next = triangle_of(arrangement.triangulation().across(h));
      if (region_[next.index()] != kNone) continue;
      region_[next.index()] = region;
      waiting.push_back(next);
    }
  }
}

// From the end of a border edge the next one is found by turning clockwise through the solid.
void SolidRegions2::find_borders(const Arrangement2& arrangement) {
  const Triangulation2& triangulation = arrangement.triangulation();
  std::vector<char> is_done(3 * region_.size(), 0);
  for (const HalfEdgeId first : triangulation.half_edges()) {
    if (of(first) == kNone || is_done[first.index()] != 0 || kind_of(arrangement, first) != Edge::kBorder) continue;
    Border& border = borders_[of(first)].emplace_back();
    HalfEdgeId h = first;
    do {
      is_done[h.index()] = 1;
      border.push_back(triangulation.origin(h));
      h = next_half_edge(h);
      while (kind_of(arrangement, h) != Edge::kBorder) h = next_half_edge(triangulation.across(h));
    } while (h != first);
  }
}

}  // namespace hottel
