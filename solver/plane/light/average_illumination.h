// The mean light in each cell of a grid.
#pragma once

#include "solver/plane/light/face_radiosity.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {

// Averages with what is proven of them.
struct AverageIllumination2 {
  IlluminationGrid2 grid;
  std::vector<double> errors;  // by cell: no channel's value is farther than this from the real number
  double max_error = 0;        // the largest of them
};

// Returns the mean, over the whole rectangle of each cell, of the mean irradiance (1/2 pi) times the integral of B over
// all directions, by a closed form. In a cell that is partly in solids, or outside a closed scene (FreeParts2), it is
// the mean over the free part; a cell of which nothing is free is NaN in every channel. Outside rooms of other scenes
// the irradiance is what is seen there.
//
//   (1) within errors[cell] of the real number for the radiosities as given (their own bounds are the solution's), when
//       arc tangents and logarithms of the library are good to two units of their last digit
//   (2) never negative, never above the largest radiosity; NaN exactly where nothing of the cell is free (error 0)
//   (3) bit-identical for any number of threads
//   (4) a cell's bound grows with the number of vertices it sees, not with the size of the scene: typically it is 1e-11
//       of the largest radiosity, over the share of the cell that is free
// progress: fraction done; may throw to stop. Throws Interrupted when asked to stop.
// REQUIRES at least one cell, min < max; a sky that sends out nothing where FreeParts2 has no outside.
// COST: 0.2 to 0.4 µs of one core for each cell and each vertex seen from it. Memory for the grid, and for the wedges
// of a few vertices at a time.
// SEE: docs/design/plane/illumination.md
AverageIllumination2 illuminate_averages(const PreparedScene2& prepared, const Grid2& grid,
                                         const FaceRadiosity2& radiosity,
                                         const std::function<void(double)>& progress = {});

}  // namespace hottel
