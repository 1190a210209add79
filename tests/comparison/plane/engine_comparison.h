// The engine against the brute force on one scene: every pair as an exact sum, every printed double.
#pragma once

#include <cstddef>
#include <string>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/root_sum.h"
#include "tests/comparison/plane/ownership.h"
#include "tests/oracle/exact_sum.h"

namespace hottel::oracle {

// The same number in the oracle's form.
ExactSum to_exact_sum(const RootSum& sum);

struct ComparisonCounts {
  std::size_t scenes = 0, pairs = 0, zeros = 0, sums = 0, factors = 0, visibilities = 0, doubles = 0, hidden = 0;
};

// Returns where the engine and the brute force differ on a scene, or nothing:
//
//   (1) both have the same pieces, each side covered or with the same owner
//   (2) S(i, j) is the same exact sum for all pairs with a row, the sky included
//   (3) an entry is there iff S > 0; its factor is the double nearest to the oracle's real number, on the right side of
//       it, in an enclosure of one ulp that contains it
//   (4) visibilities are S over the S0 of the brute force on the pieces that lie on surfaces of i or j, rounded in the
//       same way, > 0, and 1 iff S = S0
//   (5) Hidden::kYes: hidden_pairs() are those where S = 0 < S0
//
// REQUIRES that the scene is not refused. COST: that of the brute force, O(V^3); (5): once for each pair of surfaces.
enum class Hidden : bool { kNo, kYes };
std::string disagreement(const Scene2& scene, ComparisonCounts& counts, Granularity granularity = Granularity::kFace,
                         Hidden hidden = Hidden::kNo);

}  // namespace hottel::oracle
