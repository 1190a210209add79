// Pairs of triangles that pierce each other, measured by rules and proven.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/pairs/pair_integrator.h"

namespace hottel::oracle {

// A pair with something between that does not hide all; measures in units of its scene.
struct PiercedPair3 {
  double area;         // the smaller one of both
  PairResult3 sum;     // of rules that state 1e-12
  PairResult3 proven;  // within 1e-9

  // The sum, give or take the error that its rules state, rounding included, is where the bounds say.
  bool is_within_bounds() const {
    return sum.problem.empty() && proven.bounds.lower - sum.error <= sum.measure &&
           sum.measure <= proven.bounds.upper + sum.error;
  }
  // In the smaller area.
  double width() const { return proven.bounds.width() / area; }
};

// Those of three triangles, some ten for a seed, the same on every platform. COST: some 20 ms.
std::vector<PiercedPair3> pierced_pairs_3(std::uint64_t seed);

}  // namespace hottel::oracle
