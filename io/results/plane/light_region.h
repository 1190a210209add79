// Where the cells of a grid of light lie, as files say it.
#pragma once

#include "geometry/plane/scene/scene.h"
#include "io/results/npy.h"

namespace hottel {

// Returns the region of a grid in the plane, corners as the doubles next to them. [unit of the scene]
GridRegion region_of(const Grid2& grid);

}  // namespace hottel
