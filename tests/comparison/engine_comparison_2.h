// The engine against the brute force on one scene: every pair as an exact sum, every printed double.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/scene/scene_2.h"
#include "kernel/root_sum.h"
#include "tests/oracle/exact_sum.h"
#include "tests/oracle/split_2.h"

namespace hottel::oracle {

// One surface for each edge, "e0", "e1", ...; material m reflects m/4, and 2 emits 1 as well. Each is a group.
Scene2 to_scene(const std::vector<InputSegment>& edges);
std::vector<InputSegment> to_edges(const Scene2& scene);

// The same number in the oracle's form.
ExactSum to_exact_sum(const RootSum& sum);

struct ComparisonCounts {
  std::size_t scenes = 0, pairs = 0, zeros = 0, sums = 0, factors = 0, visibilities = 0, doubles = 0;
};

// Returns where the engine and the brute force differ on a scene, or nothing:
//
//   (1) both have the same pieces, each side with the same owner
//   (2) S(i, j) is the same exact sum for all pairs with a row, the sky included
//   (3) an entry is there iff S > 0; its factor is the double nearest to the oracle's real number, on the right side of
//       it, in an enclosure of one ulp that contains it
//   (4) visibilities between faces that own all of their edge are rounded in the same way, > 0, and 1 iff nothing hides
//
// REQUIRES: no conflict of claims. COST: that of the brute force, O(V^3).
std::string disagreement(const Scene2& scene, ComparisonCounts& counts);

}  // namespace hottel::oracle
