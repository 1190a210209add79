// Radiosities that are known well beside the brightest, but not relative to themselves.
#pragma once

#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Returns a note for each channel in which bounds of faint radiosities are wide: a thousand times as wide, relatively,
// as those of all are beside the brightest, and wider than 1e-9. It says of how many, names the widest three and says
// how wide they are. Bounds that are open have a note of their own.
//
//   (1) none where elimination could be had: up to kMostEliminatedUnknowns unknowns in a component, solver auto,
//       cholesky or cg without limits, factors that are normal doubles, radiosities too
std::vector<std::string> notes_of_loose_bounds(const ExchangeMatrix& matrix, const RadiositySolution& solution);

}  // namespace hottel
