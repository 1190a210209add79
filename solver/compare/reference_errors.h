// How far the reference may be off that methods are held against.
#pragma once

#include <optional>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Errors of exact factors that are not correctly rounded, and of the radiosities that follow; all 0 where every factor
// is kExact.
struct ReferenceErrors {
  double max = 0, rms = 0;  // of factors: proven where they are enclosed, else what the tolerance allows
  double radiosity = 0;     // half the width of the widest bounds of a radiosity over the largest radiosity
};

// tolerance: on S relative to the smaller area, of factors that are estimated. COST: one pass.
ReferenceErrors reference_errors(const ExchangeMatrix& exact, double tolerance,
                                 const std::optional<RadiositySolution>& solution);

}  // namespace hottel
