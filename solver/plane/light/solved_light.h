// The light of a solution in space: on a grid, and at one point.
#pragma once

#include <functional>
#include <string_view>

#include "geometry/element.h"
#include "solver/plane/light/light_values.h"

namespace hottel {

struct PreparedScene2;
struct RadiositySolution;
struct VisibilityPolygon2;

// Returns the light of a solution on a grid. way: "point" (illuminate_points), "average" (illuminate_averages, with its
// bound) or "inverse-square" (illuminate_inverse_square); these say what is thrown. Another word: ContractViolation.
// REQUIRES the solution of a matrix of the scene of that granularity.
SolvedLight2 illuminate(std::string_view way, const PreparedScene2& prepared, const Grid2& grid,
                        Granularity granularity, const RadiositySolution& solution,
                        const std::function<void(double)>& progress = {});

// Solves the scene by faces and looks around from the eye (mean_irradiance.h). Does not throw RequestError: where there
// is no solution, or none that doubles can hold, why_none says why and the lists are empty.
// REQUIRES an eye that is in no solid. COST: the exact factors of the scene and one solution.
PointLight2 light_at(const PreparedScene2& prepared, const VisibilityPolygon2& seen);

}  // namespace hottel
