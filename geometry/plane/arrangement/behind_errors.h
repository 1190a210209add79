// What is said of a "behind" that cannot be obeyed.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

struct UnboundedBehind2 {
  const Scene2& scene;
  const Overlay2& overlay;
  const FreeRegions2& regions;
  std::uint32_t group;
  const std::vector<PieceSideId>& backs;  // sides that its backs without material look from
};

// Throws InputError that names the group and why no region is behind it: every back has a material, its own fronts look
// there too, or where the outline of the region has a gap.
[[noreturn]] void refuse_unbounded(const UnboundedBehind2& behind);

// Throws InputError that names both groups.
[[noreturn]] void refuse_conflict(const Scene2& scene, std::uint32_t solid, std::uint32_t open);

}  // namespace hottel
