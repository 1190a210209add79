// The plan of a scene in space.
#pragma once

#include "geometry/exchange_request.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/plan.h"

namespace hottel {

// Returns which effects a scene in space calls for. What nothing can hide is told exactly: one convex room, and faces
// that have nothing before them.
//
//   (1) rows are those of elements where some polygon is divided, else those of faces
//   (2) light between the faces is used where a grid is asked for, a picture wherever there is a polygon
//   (3) seconds are rough, of one core, and depend on no clock: within a factor of 3 as a rule, from what some pairs
//       cost (sampled_cost.h)
//
// COST: as nothing_between.h says, some milliseconds, and a few per cent of what factors take, some tenths of a second
// as a rule; nothing is computed of the light itself.
Plan plan_scene(const PreparedScene3& prepared, const PlanRequest& request, SkyBy sky = SkyBy::kIntegral);

}  // namespace hottel
