// Whether a scene in space is one, where its polygons are known to be.
#pragma once

#include "geometry/space/scene/scene.h"

namespace hottel {

// As validate(scene), but for (2) of Scene3: where all but polygons may have changed. COST: linear, for each light too.
void validate_but_polygons(const Scene3& scene);

}  // namespace hottel
