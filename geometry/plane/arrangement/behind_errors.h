// What is said of a "behind" that cannot be obeyed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A group that says "behind": "solid", which cannot be obeyed, with all that a message about it needs. It refers to
// what it is made from and owns nothing.
struct UnboundedBehind2 {
  const Scene2& scene;
  const Overlay2& overlay;
  const FreeRegions2& regions;
  std::uint32_t group;
  const std::vector<PieceSideId>& backs;  // sides that its backs without material look from
};

// Throws InputError that names the group and says why no region is behind it, by the first of these that applies. The
// line is that of the first surface of the group.
//
//   (1) `backs` is empty: every back of the group has a material
//   (2) all backs look into region 0, the outside: the region behind them is open to infinity
//   (3) else: the fronts of the group look into the same region as its backs
//
// Hints name at most two gaps, at ends that nothing else touches: ends of the group, or else of others
// connected with it.
// REQUIRES: the group has a surface.
[[noreturn]] void refuse_unbounded(const UnboundedBehind2& behind);

// Throws InputError that names both groups: the one says that a region is solid, the other that it is open. The line
// is the greater one of their first surfaces.
// REQUIRES: both groups have a surface.
[[noreturn]] void refuse_conflict(const Scene2& scene, std::uint32_t solid, std::uint32_t open);

}  // namespace hottel
