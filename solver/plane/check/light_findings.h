// What is worth telling about the light in a scene before it is solved for.
#pragma once

#include <functional>
#include <span>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/check/finding.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

// Iterations from which convergence is called slow: what jacobi needs for a relative residual of 1e-12.
inline constexpr double kManyIterations = 1000;

// Kinds: no-solution, beyond-doubles (errors), light-in-solid (a warning), dark-sun, all-reflecting, dark,
// slow-convergence, no-light, unused-material.
//
//   (1) errors are those of light_errors (solver/check)
//   (2) the iterations of slow-convergence are what a bound from below of the spectral radius asks for
// REQUIRES: the exact matrix of the scene, by faces or by elements, and for each light its shares of these.
// COST: that of light_errors, which reports to `progress`.
Findings2 light_findings(const Scene2& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
                         const std::function<void(double)>& progress = {});

}  // namespace hottel
