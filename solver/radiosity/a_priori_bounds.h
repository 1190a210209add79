// Bounds of radiosities that hold whatever the view factors are.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Narrows the bounds of a solution by
//
//   E_i  <=  B_i  <=  E_i + rho_i (M + D_i),
//   M = max(emission of the sky, (E_j + rho_j D_j) / (1 - rho_j) over all faces with a material)
//
// and those of the net by E_i - (1 - rho_i) (M + D_i) and E_i - (1 - rho_i) D_i, for any sources within their
// enclosures, rounded outward, and its relative widths by those of these bounds.
//
//   (1) the radiosities of the exact factors still lie within: their rows sum to 1, so that no face receives more than
//       the brightest thing in the scene sends out
//   (2) M is infinite where a face with reflectivity 1 emits or is shone on directly
//   (3) where a radiosity is moved into its bounds the irradiances are summed anew
//   (4) nothing is narrowed where sources are withdrawn: E is then no lower bound
//   (5) of two bands only the solar one is narrowed
//   (6) what the notes say of upper bounds that are missing (notes_of_unbounded_rows) is true of the bounds afterwards
// REQUIRES: the solution of `matrix` with these reflectivities (by material) and sources, proven of the scene: none of
// its factors is estimated.
void set_a_priori_bounds(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity,
                         const RadiositySources& sources, RadiositySolution& solution);

// The same with the sources of a scene: what its materials and the sky emit.
void set_a_priori_bounds(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                         const Spectrum& sky_emission, RadiositySolution& solution);

}  // namespace hottel
