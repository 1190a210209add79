// Closes the gaps of a scene in space, whatever comes of it. Internal to geometry/space/check.
#pragma once

#include <vector>

#include "geometry/space/check/repaired_scene.h"

namespace hottel {

// What close_gaps does, but for its (6): polygons that are held (by number) keep their corners where they are, and all
// others move though more may be found then than before.
Repair3 closed_gaps(const Scene3& scene, const Rational& distance, const std::vector<char>& held);

}  // namespace hottel
