// Where the cells of a grid of light in space lie, as files say it.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "io/results/npy.h"

namespace hottel {

// Returns the region of a grid in space, its corner and sides as the doubles next to them. [unit of the scene]
GridRegion3 region_of(const Grid3& grid);

// Returns the shape of an array of one number a cell: (nv, nu), of a volume (nw, nv, nu).
std::vector<std::size_t> array_shape(const Grid3& grid);

}  // namespace hottel
