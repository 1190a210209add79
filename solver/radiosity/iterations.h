// The iterations that the literature of radiosity describes, in plain doubles.
#pragma once

#include <functional>
#include <vector>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {

// When to stop: after so many iterations, or once the residual is small enough; always when it is no finite number.
struct IterationLimits {
  int iterations;
  double until;  // max |residual|, each relative to the largest source of its component
};

// What an iteration came to. It proves nothing: certify() bounds it (certificate.h).
//
//   (1) the history has one number more than iterations were done; those of jacobi and gauss_seidel are residuals, the
//       last that of x, those of shooting the largest light that was not shot yet
//   (2) a system that is solved from the start comes back unchanged, after no iteration
struct IterationResult {
  std::vector<double> x;
  std::vector<double> history;  // max |residual| as above, the start first
};

// x <- E + rho F x, from x = source. Each iteration is one more bounce of light. All three stop with Interrupted when
// that was asked for.
// COST of an iteration: one pass over the entries.
IterationResult jacobi(const PlainSystem& system, const PlainSource& source, const IterationLimits& limits);

// The same, with each new value used at once, in the order of the elements. COST: two passes over the entries, one of
// them for the residual.
IterationResult gauss_seidel(const PlainSystem& system, const PlainSource& source, const IterationLimits& limits);

// Progressive refinement (Cohen, Chen, Wallace, Greenberg 1988), without an ambient term: the element with the
// most unshot power, in the unit of its component, shoots to all that it sees. The result is what was received,
// the unshot light included.
// COST of an iteration (one shot): one pass over the unknowns, and the column of the one that shoots.
IterationResult shooting(const PlainSystem& system, const PlainSource& source, const IterationLimits& limits);

}  // namespace hottel
