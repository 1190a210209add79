// Patches: what exchanges light in space.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/determinant.h"

namespace hottel {

// A convex plane polygon that sends out or receives light on one side: a face of a surface, or an element of a face; or
// a part of the sky, or all of it. Patches hide nothing: what hides are surfaces, whole (Occluders3).
//
//   (1) corner k lies at corners[k] / weight in integer form (Vertices3), exactly; weight >= 0. Where the weight is 0
//       corners are directions, and the patch is the part of the sky in the convex cone between them
//   (2) seen from its front its corners run counter-clockwise; it has an area; no three in a row are on one line. Parts
//       of the sky are seen from within
//   (3) it lies within its surface, which is the polygon of that number of Occluders3; a part of the sky within none
//   (4) all of the sky has no corners
struct Patch3 {
  static constexpr std::uint32_t kSky = 0xffffffff;

  std::uint32_t surface = kSky;
  std::vector<IntegerVector> corners;
  Integer weight = 1;

  static Patch3 all_of_the_sky() { return {kSky, {}, 0}; }

  bool is_sky() const { return surface == kSky; }
  bool is_all_of_the_sky() const { return is_sky() && corners.empty(); }
  // Whether its corners are directions.
  bool is_far() const { return weight == 0; }
};

// The direction of its front, of any length. REQUIRES: it is not far.
inline IntegerVector normal_of(const Patch3& patch) {
  const auto& corners = patch.corners;
  return cross(difference(corners[1], corners[0]), difference(corners[2], corners[1]));
}

}  // namespace hottel
