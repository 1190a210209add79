// For tests: radiosities with parts of the certificate left out.
#pragma once

#include "solver/radiosity/radiosity.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {

RadiositySolution solve_radiosity_without(const ErrorTerms& terms, const ExchangeMatrix& matrix,
                                          const std::vector<Material>& materials, const Spectrum& sky_emission,
                                          const RadiosityOptions& options);

}  // namespace hottel
