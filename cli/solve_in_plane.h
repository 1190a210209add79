// hottel solve in the plane.
#pragma once

#include "cli/solve_options.h"
#include "cli/streams.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Computes and writes the radiosities of a scene in the plane, and the light between its faces. Throws UsageError for
// options that are of space. seconds_to_read: what the scene took, for the report.
// REQUIRES options that make sense in one dimension at least (solve.cpp).
void solve_in_plane(const SolveOptions& options, ValidScene2 scene, double seconds_to_read, Streams& streams);

}  // namespace hottel
