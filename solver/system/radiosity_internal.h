// For tests: radiosities with parts of the certificate left out.
#pragma once

#include "solver/system/radiosity.h"
#include "solver/system/radiosity_system.h"

namespace hottel {

RadiositySolution solve_radiosity_without(const ErrorTerms& terms, const ExchangeMatrix& matrix,
                                          const std::vector<Material>& materials, const Spectrum& sky_emission,
                                          const RadiosityOptions& options);

}  // namespace hottel
