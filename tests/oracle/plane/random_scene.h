// Small random scenes, full of contacts, for comparing exact results.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/oracle/plane/split.h"

namespace hottel::oracle {

struct RandomScene {
  std::vector<InputSegment> edges;
};

// Returns n edges, the same for the same arguments on every platform.
//
//   (1) split(edges) reports no conflict: materials (0, 1, 2, or -1 on backs only) are made equal where faces overlap
//   (2) lattice: end points on a small square lattice of step 1, 1/2, 1/3 or 1/10; crossings, T-junctions, touching
//       tips, overlaps, repetitions and reversed repetitions all occur
//   (3) not lattice: end points are decimals of three digits; edges share end points or stay apart
//   (4) in every second scene (odd seed) the first four edges are a closed room around the others, fronts inside
// REQUIRES: n >= 4.
RandomScene random_scene(std::uint64_t seed, int n, bool lattice);

// Makes the materials of faces equal that claim the same side of a piece, and those of their groups, and returns
// split(edges), which then reports no conflict. REQUIRES edges of one group that have the same materials.
void settle_conflicts(std::vector<InputSegment>& edges);
Split settle_conflicts(std::vector<InputSegment>& edges, const Cut& cut);

}  // namespace hottel::oracle
