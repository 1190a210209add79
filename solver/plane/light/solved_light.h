// The light of a solution on a grid.
#pragma once

#include <functional>
#include <string_view>

#include "geometry/element.h"
#include "solver/plane/light/light_values.h"

namespace hottel {

struct PreparedScene2;
struct RadiositySolution;

// Returns the light of a solution on a grid. way: "point" (illuminate_points), "average" (illuminate_averages, with its
// bound) or "inverse-square" (illuminate_inverse_square); these say what is thrown. Another word: ContractViolation.
// REQUIRES the solution of a matrix of the scene of that granularity.
SolvedLight2 illuminate(std::string_view way, const PreparedScene2& prepared, const Grid2& grid,
                        Granularity granularity, const RadiositySolution& solution,
                        const std::function<void(double)>& progress = {});

}  // namespace hottel
