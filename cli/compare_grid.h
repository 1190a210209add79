// hottel compare --grid-file: light on a grid by another program, against the exact light of the same cells.
#pragma once

#include <string>

#include "cli/comparing.h"

namespace hottel {

// What a grid file came to: a csv, a picture of where it is off, and sentences.
struct JudgedGrid {
  std::string csv, picture;  // bytes of grid.csv and grid_errors.png
  std::vector<std::string> sentences;
};

// Holds a file (read_external_grid) against the exact mean irradiance at the centres of the cells: of the scene's own
// grid, or in the plane of its bounding box, with as many cells as the file has. beyond: as in grid_errors(). Throws
// InputError naming the file where it has other cells than the scene's own grid, other channels, or says that it lies
// elsewhere, and in space where the scene has no grid; RequestError where there is no exact light.
JudgedGrid judge_grid(const std::string& file, const MethodComparison2& comparison, double beyond);
JudgedGrid judge_grid(const std::string& file, const MethodComparison3& comparison, double beyond);

}  // namespace hottel
