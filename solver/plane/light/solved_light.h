// The light of a solution on a grid.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "geometry/plane/exchange/element_table.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// Light on a grid, and the proven bound on its values where there is one: for "average" alone, of these radiosities.
struct SolvedLight2 {
  IlluminationGrid2 grid;
  std::optional<double> max_error{};
  double seconds = 0;  // what it took, as a simulation measures it
};

// Returns the light of a solution on a grid. way: "point" (illuminate_points), "average" (illuminate_averages, with its
// bound) or "inverse-square" (illuminate_inverse_square); these say what is thrown. Another word: ContractViolation.
// REQUIRES the solution of a matrix of the scene of that granularity.
SolvedLight2 illuminate(std::string_view way, const PreparedScene2& prepared, const Grid2& grid,
                        Granularity granularity, const RadiositySolution& solution,
                        const std::function<void(double)>& progress = {});

}  // namespace hottel
