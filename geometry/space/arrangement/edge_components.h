// What hangs together by edges. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/occluders.h"

namespace hottel {

// The polygons of a scene in components: two of one edge are in one.
//
//   (1) components are in the order of their first polygons, their polygons ascend
//
// COST: linear.
class EdgeComponents3 {
 public:
  explicit EdgeComponents3(const Occluders3& occluders);

  const std::vector<std::vector<std::uint32_t>>& all() const { return all_; }
  std::uint32_t of_polygon(std::uint32_t polygon) const { return of_polygon_[polygon]; }
  // The polygons of an edge, ascending.
  const std::vector<std::uint32_t>& of_edge(EdgeId3 edge) const { return of_edge_[edge.index()]; }

 private:
  std::vector<std::vector<std::uint32_t>> all_, of_edge_;
  std::vector<std::uint32_t> of_polygon_;
};

}  // namespace hottel
