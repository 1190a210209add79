// What view factors of a scene in space cost, from some of their pairs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/determinant.h"

namespace hottel {

// Costs in seconds of one core, reckoned from what was looked at for pairs (nodes, signs), never from a clock.
//
//   (1) the same scene has the same costs, on every machine and any number of threads
//   (2) plain <= pairs: what the pairs would cost with nothing between them
//   (3) where all pairs were measured, costs are sums; else they are extrapolated, and rough
struct SampledCost3 {
  double facing = 0;            // about how many pairs of patches face each other, one of them of an element with a row
  double plain = 0, pairs = 0;  // of these pairs together
  double sky = 0;               // of all patches of elements with rows, each with the sky
  double sampling = 0;          // of what was measured to tell the others
  std::size_t measured = 0;     // pairs, those with the sky among them
};

// What nodes of integrals and signs, by the tiers that settled them, take. [s, one core]
double seconds_of_looks_3(std::uint64_t nodes, const SignCounts& signs);

// Draws pairs by fixed seeds, more often those between which more surfaces may stand, and measures some: a few per cent
// of what all seem to cost, or some tenths of a second, whichever is less; but one at the least.
// wants_sky: whether elements see the sky at all. COST: as `sampling` says, and some 10 microseconds for each of up to
// a thousand pairs.
SampledCost3 sampled_cost(const PreparedScene3& prepared, bool wants_sky);

}  // namespace hottel
