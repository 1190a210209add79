// Radiosities of a scene from its view factors, with proven bounds.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Solves B_i = E_i + rho_i sum_j F_ij B_j in every channel, once: what RadiositySolver says holds, with the emissions
// of the materials and of the sky as the only sources. Seconds are those of all that was done.
//
// solve_sources does the same for any sources, whose emissions need not be those of the materials.
//
// Throws RequestError and ContractViolation as RadiositySolver and its solve() do.
// REQUIRES: the materials of the elements index into `materials`.
// COST: one factorization per distinct reflectivity vector, then a few passes over the matrix per channel. Three times
// that where the weakest entry is enclosed.
RadiositySolution solve_radiosity(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                  const Spectrum& sky_emission, const RadiosityOptions& options = {});
RadiositySolution solve_sources(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                const RadiositySources& sources, const RadiosityOptions& options = {});

}  // namespace hottel
