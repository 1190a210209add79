// Surfaces as patches.
#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"

namespace hottel {

// Turns a patch to the other side: its first corner stays the first.
inline void turn_round(Patch3& patch) { std::reverse(patch.corners.begin() + 1, patch.corners.end()); }

// Returns the front or the back of a surface, whole.
inline Patch3 whole_patch(const Occluders3& occluders, std::uint32_t surface, bool is_back = false) {
  Patch3 patch{.surface = surface, .corners = {}};
  for (const VertexId3 v : occluders.outline(surface)) patch.corners.push_back(occluders.vertices().exact(v));
  if (is_back) turn_round(patch);
  return patch;
}

}  // namespace hottel
