// Faces as stripes on their own side of the edge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viewer/picture/plane/corners.h"

namespace hottel {

// The stripes of one thickness along some edges. Where two striped edges meet in a corner their stripes are mitred, so
// that they neither overlap nor leave a gap.
//
//   (1) a stripe lies on the right of its edge
//   (2) it is at most as deep as `thickness`, less on a short edge between narrow corners
//   (3) it reaches beyond the ends of the edge only around a corner, by at most 1.2 thicknesses
//   (4) where no striped edge is next in a corner narrower than a right angle, it ends at that edge
// Degenerate: an edge without length has a stripe without area. Edges of one direction at a corner are one wall.
class Stripes2 {
 public:
  // is_striped: which edges get a stripe, one entry for each. REQUIRES that the corners outlive this. COST: O(n log n).
  Stripes2(const Corners2& corners, std::vector<bool> is_striped, double thickness);

  // The four corners: along the edge, then back along the outer border.
  std::array<Pixel, 4> stripe(std::uint32_t edge) const;

 private:
  struct Ray {
    double angle;  // of the edge, away from the corner
    std::uint32_t edge;
    bool leaves;  // the corner is `from`
  };
  // How much the outer border is shorter than the edge at that end.
  double shortening(std::uint32_t edge, bool at_from) const;
  bool striped(const Ray& ray, int turn) const;

  const Corners2& corners_;
  std::vector<bool> is_striped_;
  double thickness_;
  std::vector<std::uint32_t> first_ray_;  // per corner, into rays_
  std::vector<Ray> rays_;                 // per corner, by angle
  std::vector<std::uint32_t> ray_of_;     // edge s at its `from`: 2 s, at its `to`: 2 s + 1
};

}  // namespace hottel
