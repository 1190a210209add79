// The plan of a scene in the plane.
#pragma once

#include <cstdint>

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plan.h"

namespace hottel {

// Returns which effects a scene in the plane calls for, one convex room being told from others exactly. Seconds are
// rough, of one core: from how many vertices some vertices see, and how many pairs that makes; within a factor of 3 in
// the showcase scenes and in clutter. A convex room has its factors in no effect: they cost less than all else.
// REQUIRES a scene prepared with its elements (Divided2::kYes), where it has any.
// COST: O(n), and the views from 64 vertices; nothing is computed of the light itself.
Plan plan_scene(const PreparedScene2& prepared, const PlanRequest& request);

// Returns how many pixels a picture of light on a grid has, of the usual size: for PlanRequest::grid_pixels.
std::uint64_t picture_pixels_2(const Grid2& grid);

// Seconds of one core that the exact factors of so many pairs take, the arrangement of so many vertices included.
double seconds_of_factors_2(double vertices, double pairs);

// What it adds where so many pairs are on disk meanwhile.
double seconds_on_disk_2(double pairs);

}  // namespace hottel
