#include "solver/plane/light/free_parts.h"

#include "geometry/plane/arrangement/solid_regions.h"

namespace hottel {

FreeParts2::FreeParts2(const PreparedScene2& prepared) {
  const Arrangement2& arrangement = prepared.arrangement;
  if (arrangement.solids().is_empty() && !prepared.scene.closed) return;
  const Triangulation2& triangulation = arrangement.triangulation();
  const SolidRegions2 solids(arrangement);
  for (const TriangleId t : triangulation.triangles())
    is_free_.push_back(solids.of(half_edge(t, 0)) == SolidRegions2::kNone ? 1 : 0);
  if (prepared.scene.closed) leave_out_dark_regions(prepared);
}

// Region by region: triangles that are connected across edges without a piece, and what lies outside of all.
void FreeParts2::leave_out_dark_regions(const PreparedScene2& prepared) {
  const Arrangement2& arrangement = prepared.arrangement;
  const Triangulation2& triangulation = arrangement.triangulation();
  const auto has_material = [&](PieceSideId side) {
    if (arrangement.is_covered(side)) return false;
    const Face& face = arrangement.owner(side);
    return prepared.scene.surfaces[face.surface].material_of(face.is_back).has_value();
  };
  std::vector<char> is_done(triangulation.triangle_count(), 0);
  const auto visit = [&](std::vector<TriangleId> region, bool is_outside) {
    for (const TriangleId t : region) is_done[t.index()] = 1;
    bool is_lit = false;
    for (std::size_t k = 0; k < region.size(); ++k)
      for (const HalfEdgeId h : half_edges_of(region[k])) {
        is_lit = is_lit || (triangulation.is_piece(h) && has_material(triangulation.side(h)));
        if (!triangulation.is_open(h)) continue;
        const TriangleId next = triangle_of(triangulation.across(h));
        if (is_done[next.index()] != 0) continue;
        is_done[next.index()] = 1;
        region.push_back(next);
      }
    // Pieces on the hull have one side outside.
    if (is_outside)
      for (const HalfEdgeId h : triangulation.half_edges())
        if (triangulation.is_piece(h) && triangulation.across(h).is_none())
          is_lit = is_lit || has_material(opposite(triangulation.side(h)));
    if (is_lit) return;
    for (const TriangleId t : region) is_free_[t.index()] = 0;
    if (is_outside) has_outside_ = false;
  };
  std::vector<TriangleId> at_hull;
  for (const HalfEdgeId h : triangulation.half_edges())
    if (triangulation.is_bare_hull(h) && is_done[triangle_of(h).index()] == 0) {
      is_done[triangle_of(h).index()] = 1;
      at_hull.push_back(triangle_of(h));
    }
  visit(std::move(at_hull), true);
  for (const TriangleId t : triangulation.triangles())
    if (is_done[t.index()] == 0 && is_free_[t.index()] != 0) visit({t}, false);
}

}  // namespace hottel
