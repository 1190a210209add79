// The map of the eye of a camera.
#pragma once

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {

// Returns what the eye of a camera sees of the half space before it. Throws RequestError where it is in a solid.
// REQUIRES a camera without a problem. COST: that of a map.
VisibilityMap3 eye_map_3(const PreparedScene3& prepared, const Camera3& camera);

}  // namespace hottel
