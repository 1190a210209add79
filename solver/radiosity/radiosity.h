// Radiosities of a scene from its view factors, with proven bounds.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Solves B_i = E_i + rho_i sum_j F_ij B_j in every channel.
//
//   (1) lower <= true B <= upper in every element, the true B being that of the exact reflectivities, emissions and
//       factors; where some entries are enclosed and none is estimated, of any factors within their bounds; where some
//       are estimated, of the doubles that the matrix holds. The last says nothing of the scene: `guarantee` is then
//       kEstimated, else kEnclosed
//   (2) lower = upper = 0 = B where no light reaches; B = E within half an ulp where rho = 0; lower is never below the
//       largest double that is not above E, net_upper never above the smallest that is not below it (unless a factor is
//       negative)
//   (3) widths of a few ulps after cholesky and cg, or up to 3 n ulps for n unknowns where doubles do not do
//       (high_precision_elimination.h), for any distance of rho from 1 and for elements that next to no light reaches;
//       for an enclosed matrix a few ulps more than the radiosities of its factors differ, and infinite where for some
//       of them light need not die out (enclosed_radiosity.h)
//   (4) each component is bounded on its own scale, whatever shines elsewhere; a note names faces that remain wide
//       relative to themselves (faint_radiosities.h)
//   (5) irradiance is that of the radiosities as given, so net() is what they exchange; where iterations were stopped
//       early B = E + rho H holds within the residual only, and a note says so
//   (6) the same bit for bit for any number of threads
//
// Throws RequestError when a component with reflectivity 1 throughout and no way out emits (one that does not is 0,
// with a note), when an upper bound of an exact matrix is infinite (factors that underflow, or more light than doubles
// can tell), when rows do not sum to 1 and the spectral radius cannot be shown to be below 1, when cholesky or cg
// are asked of such a matrix, which is not symmetric, and when a factor is no number. Where an estimated
// factor is negative the equations are solved and all bounds are infinite. Rows sum to 1 in exact matrices, and are
// taken to where all entries are enclosed or exact and their bounds allow it, which concerns the radiosity, not its
// bounds.
// REQUIRES: the materials of the elements index into `materials`.
// COST: one factorization a distinct reflectivity vector; then a few passes over the matrix a channel. Three times that
// where the weakest entry is enclosed.
RadiositySolution solve_radiosity(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                  const Spectrum& sky_emission, const RadiosityOptions& options = {});

}  // namespace hottel
