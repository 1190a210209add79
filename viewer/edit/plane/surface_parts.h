// Some surfaces of a scene, taken apart into whole polylines and others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// The surfaces of [begin, end).
struct SurfaceRun2 {
  std::uint32_t begin = 0, end = 0;
};

// Each surface is in one of the two, ascending.
struct SurfaceParts2 {
  std::vector<SurfaceRun2> polylines;  // groups that are polylines (end_of_polyline), all of whose surfaces are there
  std::vector<std::uint32_t> others;
};

// Returns the parts of all surfaces of a scene. Throws ContractViolation for a group out of range. COST: linear.
SurfaceParts2 surface_parts(const Scene2& scene);

// Returns the parts of these surfaces. One that is listed twice is there once. Throws ContractViolation for an index
// out of range. COST: linear in the scene.
SurfaceParts2 surface_parts(const Scene2& scene, std::span<const std::uint32_t> surfaces);

// Returns the surfaces of all parts, ascending.
std::vector<std::uint32_t> surfaces_of(const SurfaceParts2& parts);

}  // namespace hottel
