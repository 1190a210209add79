// What other processes find of the light of a grid.
#pragma once

#include <vector>

#include "geometry/shared_work.h"

namespace hottel {

// What elements send to the centres of cells, without lights: those of some tasks.
struct LitCells {
  WorkRange tasks;             // cells in space, bands of cells in the plane
  std::vector<double> values;  // by cell and channel, as of the grid; NaN where it has none
};

}  // namespace hottel
