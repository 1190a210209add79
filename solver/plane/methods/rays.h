// Monte Carlo: rays.
#pragma once

#include <memory>

#include "solver/methods/ray_names.h"
#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// From each element n rays start, uniformly distributed over its length and by the cosine over the angle (the sine is
// uniform in (-1, 1)). F_ij is the fraction that meets j first; rays that meet nothing meet the sky. Rows sum to 1.
//
//   (1) no ray leaks: what it meets is decided exactly (geometry/plane/visibility/first_hit.h)
//   (2) the result depends on the seed alone, not on threads
//   (3) MethodReport::standard_error is sqrt(F (1 - F) / n) of the worst factor. It is the standard error of
//       independent rays; those of the other samplings are about as large in the worst case and mostly far below
//
// declared_error: with independent or stratified rays all factors stay within it but for one run in 1.7 million, the
// probability of five standard deviations (Hoeffding's inequality, for all pairs together). With stratified and Sobol
// rays the border of what is seen runs through few of the parts that hold one ray each: a bound without any chance,
// for scenes of few vertices.
//
// Rays by EmissionLaw::kUniform count no view factors, and nothing is claimed of them.
//
// Returns the method, whose report notes the seed. Throws ContractViolation for a number of rays that is out of range.
// COST: n rays for each element, in parallel.
std::unique_ptr<ExchangeMethod2> rays_method_2(const RayOptions& options);

}  // namespace hottel
