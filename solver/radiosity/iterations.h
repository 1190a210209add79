// The iterations that the literature of radiosity describes, in plain doubles.
#pragma once

#include <functional>
#include <vector>

#include "solver/radiosity/radiosity_system.h"

namespace hottel {

struct IterationLimits {
  int iterations;
  double until;  // max |residual|, each relative to the largest source of its component
};

struct IterationResult {
  std::vector<double> x;
  std::vector<double> history;  // max |residual| as above, the start first
};

// x <- E + rho F x, from x = source. Each iteration is one more bounce of light.
IterationResult jacobi(const PlainSystem& system, const IterationLimits& limits);

// The same, with each new value used at once, in the order of the elements.
IterationResult gauss_seidel(const PlainSystem& system, const IterationLimits& limits);

// Progressive refinement (Cohen, Chen, Wallace, Greenberg 1988), without an ambient term: the element with the most
// unshot power, in the unit of its component, shoots to all that it sees. The result is what was received, the unshot
// light included.
IterationResult shooting(const PlainSystem& system, const IterationLimits& limits);

}  // namespace hottel
