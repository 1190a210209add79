// Radiosities without an upper bound.
#pragma once

#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Returns a note of how many radiosities of a channel have no upper bound, one for each such number; none where all
// have one.
std::vector<std::string> notes_of_unbounded_rows(const ExchangeMatrix& matrix, const RadiositySolution& solution);

}  // namespace hottel
