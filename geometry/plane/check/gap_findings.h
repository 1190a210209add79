// What is worth telling about ends that all but touch something.
#pragma once

#include "geometry/plane/check/finding.h"
#include "geometry/plane/check/near_misses.h"

namespace hottel {

// Kinds: near-miss, overshoot. Names the largest part of a face's light that goes through each gap: the exact view
// factor toward a surface put across the gap (light that goes through several gaps counts for the first).
// `with_factors`: false leaves that part out. COST: the view factors of the scene, where there is a gap.
Findings2 gap_findings(const Scene2& scene, const std::vector<NearMiss2>& near_misses, bool with_factors);

}  // namespace hottel
