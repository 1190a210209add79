// How much of each cell of a grid there is light to speak of.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "solver/plane/light/cell_frame.h"
#include "solver/plane/light/free_parts.h"

namespace hottel {

// Returns the share of the area of each cell, number iy * nx + ix, that lies in the free parts. Nothing at all where
// these are all there is.
//
//   (1) the double nearest to the real number, but never 0 where some of the cell is free, however little: 0 means that
//       none of the cell is
//   (2) the same for any number of threads
// frame: of the same vertices and grid. Throws Interrupted when asked to stop.
// COST: about 20 µs for each cell that the border of free parts comes near; next to nothing for all others.
std::vector<double> free_shares(const Arrangement2& arrangement, const FreeParts2& parts, const Grid2& grid,
                                const CellFrame2& frame);

}  // namespace hottel
