// The light of a solution on a grid.
#pragma once

#include <functional>

#include "geometry/element.h"
#include "solver/plane/light/light_values.h"

namespace hottel {

struct PreparedScene2;
struct RadiositySolution;

// Returns the light of a solution on a grid. By illuminate_points, illuminate_averages (with its bound) or
// illuminate_inverse_square; these say what is thrown; and RequestError where a scene with lights is not asked for
// light at points. REQUIRES the solution of a matrix of the scene of that granularity.
SolvedLight2 illuminate(LightKind2 kind, const PreparedScene2& prepared, const Grid2& grid, Granularity granularity,
                        const RadiositySolution& solution, const std::function<void(double)>& progress = {});

}  // namespace hottel
