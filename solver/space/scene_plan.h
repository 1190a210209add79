// The plan of a scene in space.
#pragma once

#include "geometry/space/scene/scene.h"
#include "solver/plan.h"

namespace hottel {

// Returns which effects a scene in space calls for. What nothing can hide is told exactly: one convex room, and faces
// that have nothing before them.
//
//   (1) rows are those of elements where some polygon is divided, else those of faces
//   (2) what this version does not simulate in space is not used, whatever is asked for, and the reason says so:
//       interreflection, unreachable components, illumination, picture, lights
//   (3) seconds are rough: by the pairs that face each other, of which some are looked at, and what such pairs take in
//       rooms with boxes
//
// REQUIRES: a valid scene (validate). COST: about 10 microseconds a polygon, and as nothing_between.h says; nothing is
// computed of the light itself.
Plan plan_scene(const Scene3& scene, const PlanRequest& request);

}  // namespace hottel
