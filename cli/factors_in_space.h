// hottel factors in space.
#pragma once

#include "cli/factors_options.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Computes and writes the view factors of a scene in space. Throws UsageError for options that are of the plane so far.
void factors_in_space(FactorsOptions& options, ValidScene3 scene, const Streams& streams);

}  // namespace hottel
