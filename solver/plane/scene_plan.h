// The plan of a scene in the plane.
#pragma once

#include "geometry/plane/scene/scene.h"
#include "solver/plan.h"

namespace hottel {

// Returns which effects a scene in the plane calls for, one convex room being told from others exactly.
// COST: O(n) exact operations.
Plan plan_scene(const Scene2& scene, const PlanRequest& request);

}  // namespace hottel
