// Patches: what exchanges light in space.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/determinant.h"

namespace hottel {

// A convex plane polygon that sends out or receives light on one side: a face of a surface, an element of a face, or a
// far side of the sky. Patches hide nothing: what hides are surfaces, whole (Blockers3).
//
//   (1) corner k lies at corners[k] / weight in integer form (Vertices3), exactly; weight > 0
//   (2) seen from its front its corners run counter-clockwise; it has an area; no three in a row are on one line
//   (3) it lies within its surface, which is the polygon of that number of Blockers3; a side of the sky within none
struct Patch3 {
  static constexpr std::uint32_t kSky = 0xffffffff;

  std::uint32_t surface = kSky;
  std::vector<IntegerVector> corners;
  Integer weight = 1;

  bool is_sky() const { return surface == kSky; }
};

}  // namespace hottel
