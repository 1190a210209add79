// Where a light may be dragged in space.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/space/arrangement/solids.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns why a light of an edited scene may not be where it is, as a sentence; empty where it may: on no surface, in
// no solid, and not outside of all rooms where it was in one before.
//
//   (1) surfaces and solids are decided exactly; rooms, closed meshes with their fronts inward, in doubles
// solids: those of the scene. before: where the light was; null: nowhere. COST: linear in the polygons.
std::string light_refusal(const Scene3& scene, std::uint32_t light, const Solids3& solids, const Point3* before);

}  // namespace hottel
