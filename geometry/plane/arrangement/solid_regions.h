// The solid part of an arrangement: its triangles and its borders.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"

namespace hottel {

// The connected parts of the interior of the union of all solids.
//
//   (1) of(h) is the region that the triangle of a half-edge lies in; kNone where it is free
//   (2) two triangles are in one region iff one gets from one to the other by way of solid triangles that share an
//       edge, whatever is drawn on it: two boxes side by side are one region, two that touch in a point are two
//   (3) the borders of a region are closed runs of vertices, the solid on their left: the outer one, and one around
//       each hole. Nothing drawn inside a solid is on them
//   (4) regions are numbered from 0 to count() - 1; the half-edges of one triangle lie in one region
//
// It keeps nothing of the arrangement.
// COST: linear in the triangles; nothing in a scene without solids.
class SolidRegions2 {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;
  using Border = std::vector<VertexId>;

  explicit SolidRegions2(const Arrangement2& arrangement);

  std::uint32_t count() const { return static_cast<std::uint32_t>(borders_.size()); }
  std::uint32_t of(HalfEdgeId h) const { return region_.empty() ? kNone : region_[triangle_of(h).index()]; }
  const std::vector<Border>& borders(std::uint32_t region) const { return borders_[region]; }

 private:
  void fill(const Arrangement2& arrangement, TriangleId first);
  void find_borders(const Arrangement2& arrangement);

  std::vector<std::uint32_t> region_;         // by triangle; empty where nothing is solid
  std::vector<std::vector<Border>> borders_;  // by region
};

}  // namespace hottel
