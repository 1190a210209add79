// The plan of a scene in the plane.
#pragma once

#include "geometry/plane/scene/scene.h"
#include "solver/plan.h"

namespace hottel {

// Returns which effects a scene calls for.                                   COST: O(n) exact operations.
Plan plan_scene(const Scene2& scene, const PlanRequest& request);

}  // namespace hottel
