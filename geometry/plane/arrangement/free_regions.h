// The connected parts of the plane without the pieces of an arrangement.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/triangulation.h"

namespace hottel {

// The regions of free space, and the sides of pieces around each.
//
//   (1) region 0 is the one that reaches infinity; the others are bounded
//   (2) two sides are in one region iff light can go from one to the other, perhaps by way of other sides and of the
//       sky: along a path in free space the line through a point changes one of its two ends at a time, so that the
//       pairs of sides (and sky) that exchange light form one connected graph in each region
//   (3) each side stands in sides(region) for one region only, its own; sides ascend
//
// Degenerate: where all pieces lie on one line there is region 0 alone, with all sides.
// COST: linear in the triangles.
class FreeRegions2 {
 public:
  // REQUIRES the triangulation of an arrangement that has so many sides.
  FreeRegions2(const Triangulation2& triangulation, std::size_t side_count);

  std::uint32_t count() const { return static_cast<std::uint32_t>(begin_.size() - 1); }
  std::size_t side_count() const { return of_side_.size(); }
  // The region that a side looks into. REQUIRES: a side, not the sky.
  std::uint32_t of(PieceSideId side) const { return of_side_[side.index()]; }
  std::span<const PieceSideId> sides(std::uint32_t region) const {
    return {sides_.data() + begin_[region], sides_.data() + begin_[region + 1]};
  }

 private:
  std::vector<std::uint32_t> of_side_;
  std::vector<PieceSideId> sides_;  // by region, ascending
  std::vector<std::size_t> begin_;
};

}  // namespace hottel
