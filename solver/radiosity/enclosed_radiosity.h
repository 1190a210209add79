// Radiosities for any view factors within their enclosures.
#pragma once

#include <functional>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// What solves for one matrix of doubles; `is_whole` is false where only bounds are wanted, which may then be open.
using SolveDoubles =
    std::function<RadiositySolution(const ExchangeMatrix& matrix, const RadiosityOptions& options, bool is_whole)>;

// Solves a matrix with enclosed entries by solving three: that of its doubles, of the lower ends of all bounds, of the
// upper.
// All entries of (I - rho F)^-1 = I + rho F + (rho F)^2 + ... ascend with every factor, and so do radiosities and
// irradiances. What the lower and the upper ends give is therefore the smallest and the largest there is:
//
//   (1) lower <= B_i <= upper and net_lower <= net_i <= net_upper for all factors within the bounds for which light
//       dies out (spectral radius of rho F below 1); an upper bound that is finite proves that it does for all of them
//   (2) no bounds are narrower, but for the few ulps of the two solutions
//   (3) the radiosities of the doubles are moved into these bounds, the irradiances are those of what is then there
//   (4) `dark`, and a radiosity of exactly 0, is what no light reaches for any of these factors
// REQUIRES: some entry is enclosed, none is estimated. COST: three solutions, and copies of the factors of two.
RadiositySolution solve_enclosed(const ExchangeMatrix& matrix, const Spectrum& sky_emission,
                                 const RadiosityOptions& options, const SolveDoubles& solve);

}  // namespace hottel
