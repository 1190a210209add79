// Counted rays that are transposed, scaled, or leave by another law.
#pragma once

#include <vector>

#include "solver/compare/hypotheses.h"
#include "solver/compare/judged_pairs.h"
#include "solver/compare/judged_scene.h"

namespace hottel {

// Returns the scatter of rays (sampling_noise.h) about what other faults make of the factors: rays that leave evenly in
// all directions (kEmission), an order of the indices, a constant.
//
//   (1) the orders and constants are those of reading_parts.h. That one is taken about which the errors are least, each
//       divided by what a ray scatters; simpler ones where it does not halve their squares
//   (2) where nothing is taken it is the scatter about the exact factors, which may lean
//   (3) where a sum is too large by more than a fifth, which no loss of hits explains, the factors are no counts; and
//       errors that follow from where elements lie are no scatter (error_geometry.h), nor those of evenly spread rays
//       whose rows do not close: then nothing is explained
// leave_out, may_lean: as sampling_noise() takes them.
// COST: JudgedScene::uniform_factors() where the errors are no scatter about the exact factors, or lean.
Hypothesis suppose_scatter(const JudgedScene& scene, const JudgedPairs& judged, const std::vector<char>& leave_out,
                           bool may_lean);

}  // namespace hottel
