// Whether a scene in space is one, where its polygons are known to be.
#pragma once

#include "geometry/space/scene/scene.h"

namespace hottel {

// As validate(scene), but for (2) and (6) of Scene3: where all but polygons, and what patches lie on, may have changed.
// COST: linear, for each light too.
void validate_but_polygons(const Scene3& scene);

}  // namespace hottel
