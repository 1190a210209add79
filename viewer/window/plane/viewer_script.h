// What scripts ask of a viewer in the plane.
#pragma once

#include <string>

#include "viewer/window/plane/live_scene.h"

namespace hottel {

// Returns a line with the SHA-256 of each file that a fresh process would write of the scene as it is: factors.csv
// (`hottel factors`), radiosity.csv and illumination.npy (`hottel solve`); "-" for each where there is no light, or, as
// while something is dragged, a coarse one.
std::string result_hashes(const LiveState2& state);

}  // namespace hottel
