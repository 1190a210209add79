// What is worth telling about the light in a scene before it is solved for.
#pragma once

#include "geometry/check/finding.h"
#include "geometry/exchange/exchange_matrix.h"

namespace hottel {

// Iterations from which convergence is called slow: what jacobi needs for a relative residual of 1e-12.
inline constexpr double kManyIterations = 1000;

// Kinds: no-solution (error), all-reflecting, dark, slow-convergence, no-light, unused-material.
//
//   (1) no-solution is told iff solve_radiosity refuses the scene for a component that reflects all light and emits
//   (2) the iterations of slow-convergence are what a bound from below of the spectral radius asks for
// REQUIRES: the exact matrix of the scene, by faces or by elements.
Findings light_findings(const Scene2& scene, const ExchangeMatrix& matrix);

}  // namespace hottel
