// Irradiances of radiosities that were moved into their bounds.
#pragma once

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Sets the irradiance of every row to sum_j F_ij B_j + D_i of the radiosities of the solution as they are now, with the
// middle of D_i, and moves net_value into its bounds.
//
//   (1) the sum is formed to about 100 bits and rounded once; it is never below 0
// REQUIRES a solution of this matrix with these sources; `of` is the channel of theirs. COST: one pass over the matrix.
void set_irradiances(const ExchangeMatrix& matrix, const RadiositySources& sources, int of, ChannelSolution& channel);

}  // namespace hottel
