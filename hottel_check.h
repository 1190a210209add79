// What is probably wrong with a scene: what Simulation2::check and lost_light return.
#pragma once

#include "geometry/plane/check/finding.h"    // Finding2
#include "solver/plane/check/scene_check.h"  // SceneCheck2
