// Radiosities of view factors as they are, their enclosures left aside.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// Solves for the factors that the rows hold: real numbers where they are exact, else the doubles. As solve_radiosity()
// says otherwise, but for the notes on faint radiosities.
//
// `may_be_open`: factors for which light need not die out are not refused, and leave bounds open instead. `terms`: what
// of the certificate is left out, for tests that show that it is needed. REQUIRES DefaultFloatingPoint.
RadiositySolution solve_as_given(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                 const Spectrum& sky_emission, const RadiosityOptions& options, bool may_be_open,
                                 const ErrorTerms& terms = {});

}  // namespace hottel
