// The plan of a scene in the plane.
#pragma once

#include "geometry/plane/scene/scene.h"
#include "solver/plan.h"

namespace hottel {

// Returns which effects a scene in the plane calls for, one convex room being told from others exactly. Seconds are
// rough: from the showcase scenes, by the number of elements that have a row; within a factor of 3 there, and of
// clutter. A convex room has its factors in no effect: they cost less than all else. COST: O(n) exact operations;
// nothing is computed of the light itself.
Plan plan_scene(const Scene2& scene, const PlanRequest& request);

}  // namespace hottel
