// Where the cells of a grid of light in space lie, as files say it.
#pragma once

#include <string>

#include "geometry/space/scene/scene.h"
#include "io/results/npy.h"

namespace hottel {

// Returns the region of a grid in space, its corner and sides as the doubles next to them. [unit of the scene]
PlanarRegion region_of(const Grid3& grid);

// Returns the name of a file of a grid: that one, or with the name of a grid that has one before its ending:
// illumination-NAME.npy.json.
std::string grid_file(const std::string& file, const Grid3& grid);

}  // namespace hottel
