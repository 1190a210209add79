// Monte Carlo in space: rays, traced by Embree.
#pragma once

#include <memory>

#include "solver/methods/ray_names.h"
#include "solver/space/methods/exchange_method.h"

namespace hottel {

// From each element n rays start, uniformly distributed over its area and by the cosine over the angle. F_ij is the
// fraction that meets j first; rays that meet nothing meet the sky. Rows sum to 1.
//
//   (1) the result depends on the seed alone, not on threads
//   (2) MethodReport::standard_error is sqrt(F (1 - F) / n) of the worst factor. It is the standard error of
//       independent rays; those of the other samplings are about as large in the worst case and mostly far below
//
// declared_error: of independent rays and of strata all factors stay within it but for one run in 1.7 million, the
// probability of five standard deviations, by inequalities for bounded numbers (Hoeffding's; see rays.cpp), for all
// pairs together. 1e-4 of it is no bound but an allowance: for what single precision shifts. Of Sobol rays nothing is
// claimed.
//
// Embree works in single precision: what is smaller than some 1e-6 of the scene is not told apart. Rays never meet the
// piece that they start from. (kStratified: places and directions each in strata of their own, paired at random.)
//
// Rays by EmissionLaw::kUniform count no view factors, and nothing is claimed of them.
//
// Returns the method, whose report notes the seed. Throws ContractViolation for a number of rays that is out of range.
// COST: n rays for each element, in parallel.
std::unique_ptr<ExchangeMethod3> rays_method_3(const RayOptions& options);

}  // namespace hottel
