// Where the cells of a grid of light in space lie, as files say it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "io/results/npy.h"

namespace hottel {

// Returns the region of a grid in space, its corner and sides as the doubles next to them. [unit of the scene]
GridRegion3 region_of(const Grid3& grid);

// Whether a corner and its sides, as a file tells them (origin, u, v), are those of the grid but for roundings.
bool are_sides_of(const std::array<std::array<double, 3>, 3>& told, const Grid3& grid);

// Returns the shape of an array of one number a cell: (nv, nu), of a volume (nw, nv, nu).
std::vector<std::size_t> array_shape(const Grid3& grid);

}  // namespace hottel
