// The mean irradiance of each cell of a grid in space.
#pragma once

#include "geometry/exchange_request.h"
#include "solver/space/light/illumination_grid.h"

namespace hottel {

// Returns the mean irradiance of each cell of a grid, on the side that u x v points to: what an area that is the cell,
// black and behind which nothing is seen, gathers of the radiosities, the sky and the lights, over its area. It is told
// by the view factors from the cell to all elements, as these are told of elements. [unit: that of radiosity]
//
//   (1) of a cell that solids cover in part it is the mean over the part that is free; a cell of which nothing is free
//       is NaN in every channel, and so is one that sees no face with a material where the scene is closed
//   (2) errors[cell] is proven: no channel's value is farther than this from the real number, for the radiosities as
//       given (their own bounds are the solution's). It is wide where a factor is estimated, and narrow for all where
//       the request proves; 0 for NaN
//   (3) cells do not hide anything, from each other or from others; where one lies on a face it has the place of it, on
//       the side that it looks to
//   (4) the same bits for any number of threads
//
// asked: granularity, tolerance, whether it proves, the way of the sky, memory and progress are those of the factors;
// rows are those of cells. Throws as exact_exchange; Interrupted when asked to stop. REQUIRES the solution of the
// scene's matrix by that granularity, and a grid that is no volume. COST: that of the rows of as many elements as there
// are cells, and of a scene with as many polygons more.
IlluminationGrid3 average_irradiance(const PreparedScene3& prepared, const RadiositySolution& solution,
                                     const Grid3& grid, ExchangeRequest asked);

}  // namespace hottel
