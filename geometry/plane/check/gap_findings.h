// What is worth telling about ends that all but touch something.
#pragma once

#include "geometry/plane/check/finding.h"
#include "geometry/plane/check/near_misses.h"

namespace hottel {

// Returns what is worth telling about near misses. Kinds: near-miss, overshoot. Each names the largest part of a
// face's light that goes through its gap: the exact view factor toward a surface put across the gap. Light that goes
// through several gaps counts for the first. `with_factors`: false leaves that part out.
//
// REQUIRES: the near misses of this scene (find_near_misses).
// COST: the view factors of the scene, where there is a gap.
Findings2 gap_findings(const Scene2& scene, const std::vector<NearMiss2>& near_misses, bool with_factors);

}  // namespace hottel
