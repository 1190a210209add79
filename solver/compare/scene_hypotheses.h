// Hypotheses that take a look at the scene: what hides, and which side is which.
#pragma once

#include <vector>

#include "solver/compare/hypotheses.h"
#include "solver/compare/judged_pairs.h"
#include "solver/compare/judged_scene.h"

namespace hottel {

// `unobstructed`: as JudgedScene::unobstructed_factors() returns them.
Hypothesis suppose_no_occlusion(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Hypothesis suppose_all_or_nothing(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Hypothesis suppose_behind(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Hypothesis suppose_reversed(const JudgedScene& scene, const JudgedPairs& judged);

}  // namespace hottel
