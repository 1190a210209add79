#include "geometry/plane/arrangement/solid_regions.h"

namespace hottel {
namespace {

enum class Edge : unsigned char { kOpen, kWithin, kBorder };

// What an edge of a solid triangle is: no piece, one inside the solid, or one on its border.
Edge kind_of(const Arrangement2& arrangement, HalfEdgeId h) {
  if (arrangement.triangulation().twin(h) >= 0) return Edge::kOpen;
  return arrangement.is_covered(arrangement.triangulation().side(h) ^ 1) ? Edge::kWithin : Edge::kBorder;
}

}  // namespace

SolidRegions2::SolidRegions2(const Arrangement2& arrangement) {
  if (arrangement.solids().is_empty()) return;
  const Triangulation2& triangulation = arrangement.triangulation();
  region_.assign(triangulation.triangle_count(), kNone);
  const auto half_edges = static_cast<HalfEdgeId>(3 * triangulation.triangle_count());
  for (HalfEdgeId h = 0; h < half_edges; ++h) {
    const bool looks_at_a_piece = triangulation.twin(h) < 0 && triangulation.side(h) != kSky;
    if (looks_at_a_piece && arrangement.is_covered(triangulation.side(h)) && of(h) == kNone) fill(arrangement, h);
  }
  find_borders(arrangement);
}

void SolidRegions2::fill(const Arrangement2& arrangement, HalfEdgeId first) {
  const std::uint32_t region = count();
  borders_.emplace_back();
  std::vector<HalfEdgeId> waiting{first - first % 3};
  region_[static_cast<std::size_t>(first / 3)] = region;
  while (!waiting.empty()) {
    const HalfEdgeId triangle = waiting.back();
    waiting.pop_back();
    for (HalfEdgeId h = triangle; h < triangle + 3; ++h) {
      if (kind_of(arrangement, h) == Edge::kBorder) continue;
      const HalfEdgeId next = arrangement.triangulation().across(h);
      if (of(next) != kNone) continue;
      region_[static_cast<std::size_t>(next / 3)] = region;
      waiting.push_back(next - next % 3);
    }
  }
}

// From the end of a border edge the next one is found by turning clockwise through the solid.
void SolidRegions2::find_borders(const Arrangement2& arrangement) {
  const Triangulation2& triangulation = arrangement.triangulation();
  std::vector<char> is_done(3 * region_.size(), 0);
  for (HalfEdgeId first = 0; first < static_cast<HalfEdgeId>(is_done.size()); ++first) {
    if (of(first) == kNone || is_done[static_cast<std::size_t>(first)] != 0 ||
        kind_of(arrangement, first) != Edge::kBorder)
      continue;
    Border& border = borders_[of(first)].emplace_back();
    HalfEdgeId h = first;
    do {
      is_done[static_cast<std::size_t>(h)] = 1;
      border.push_back(triangulation.corner(next_half_edge(h)));
      h = next_half_edge(h);
      while (kind_of(arrangement, h) != Edge::kBorder) h = next_half_edge(triangulation.across(h));
    } while (h != first);
  }
}

}  // namespace hottel
