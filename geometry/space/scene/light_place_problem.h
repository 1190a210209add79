// Where a light of a scene in space cannot be.
#pragma once

#include <string>

#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns what is wrong with where a light is, as the end of a sentence ("lies on the surface 'floor'; a light has to
// be beside it"); empty when nothing is: Scene3 (5). Exact. COST: linear in the polygons.
std::string light_place_problem(const Scene3& scene, const Light& light, const LightPlace3& place);

}  // namespace hottel
