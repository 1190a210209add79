// The stretches of a scene's lines along which something may become visible. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/stretches/stretch.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// Where polygons end, and where they stand on each other or pierce each other: what no pair of patches changes.
//
//   (1) outlines(): every stretch of an edge beside which there may be a view, once, with all surfaces whose closure
//       contains it. Those that run through the inside of a surface, and those at which two surfaces of one plane
//       continue each other, are left out: nothing is seen past them
//   (2) grounds(s, is_back): the stretches in the plane of surface s in which others meet it that have a part in front
//       of its front, or of its back, each once, with all of these. There is_forward is as if seen with the part in
//       front alone
//   (3) exact
//
// For several threads at once. COST: about 20 microseconds a polygon.
class SurfaceStretches3 {
 public:
  SurfaceStretches3(const Occluders3& occluders, const SurfaceBoxes3& boxes);

  const IntegerVector& normal(std::uint32_t s) const { return normals_[s]; }
  const AtomicStretch3& outline(std::uint32_t number) const { return outlines_[number]; }
  // Its ends in doubles of Vertices3, to the last digits of the largest coordinate.
  const std::array<Direction3, 2>& outline_ends(std::uint32_t number) const { return outline_ends_[number]; }
  // The numbers of the outlines that a surface is at.
  std::span<const std::uint32_t> outlines_of(std::uint32_t s) const { return outlines_of_[s]; }

  std::span<const AtomicStretch3> grounds(std::uint32_t s, bool is_back) const { return grounds_[is_back ? 1 : 0][s]; }

 private:
  void add_outlines(const Occluders3& occluders, const SurfaceBoxes3& boxes);
  void add_grounds(const Occluders3& occluders, const SurfaceBoxes3& boxes, std::uint32_t s);

  std::vector<IntegerVector> normals_;
  std::vector<AtomicStretch3> outlines_;
  std::vector<std::array<Direction3, 2>> outline_ends_;
  std::vector<std::vector<std::uint32_t>> outlines_of_;
  std::array<std::vector<std::vector<AtomicStretch3>>, 2> grounds_;  // front, back
};

}  // namespace hottel
