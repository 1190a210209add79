// hottel solve in space.
#pragma once

#include "cli/solve_options.h"
#include "cli/streams.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Computes and writes the radiosities of a scene in space. Throws UsageError for options that are of the plane so far.
// seconds_to_read: what the scene took, for the report.
void solve_in_space(const SolveOptions& options, ValidScene3 scene, double seconds_to_read, Streams& streams);

}  // namespace hottel
