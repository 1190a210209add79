// Hypotheses that take a look at the scene: what hides, and which side is which.
#pragma once

#include <vector>

#include "solver/compare/hypotheses.h"
#include "solver/compare/judged_pairs.h"
#include "solver/compare/judged_scene.h"

namespace hottel {

inline constexpr double kLeastShareOfMethod = 0.2;

// Hypotheses that need more of a scene than its exact matrix. `unobstructed`: as unobstructed_factors() of
// judged_scene.h returns them, by place in judged.pairs().
//
// Factors of hidden pairs that are those without obstacles. Explains nothing unless a pair that is wholly hidden is
// among them, or no pair is wholly hidden: else something does hide, and the fault is one of all or nothing.
Hypothesis suppose_no_occlusion(const JudgedScene& scene, const JudgedPairs& judged,
                                const std::vector<double>& unobstructed);
// Factors of partly hidden pairs that are those without obstacles, or 0. The sky is left aside.
Hypothesis suppose_all_or_nothing(const JudgedPairs& judged, const std::vector<double>& unobstructed);
// Pairs that do not face each other (exact factor and unobstructed one are 0) have a factor, whatever its value. The
// sky is left aside.
Hypothesis suppose_behind(const JudgedPairs& judged, const std::vector<double>& unobstructed);
// Factors that an approximate method gives, the one that explains most. Only values other than 0 and the exact ones
// count as evidence, of which there are to be kLeastShareOfMethod of the pairs off. The sky may have what the other
// factors of the file leave of 1. COST: each method is tried on 400 pairs, and on all that are off, in parallel, where
// enough of these agree; nothing beyond kMostApproximated elements.
Hypothesis suppose_method(const JudgedScene& scene, const JudgedPairs& judged);
// The back of a surface is taken for its front: its rows and columns are those of its other side. Explains nothing
// where the scene cannot tell the factors of both sides.
//
//   (1) a surface counts only where every factor of its rows agrees once it is turned around
//   (2) where the file has all columns, a row that does not sum to 1 rules its surface out: it is missing, not turned
// COST: a pass over the pairs; that of JudgedScene::factors_of_both_sides(), another exact matrix, where some surface
// has no factor to what it cannot reach from behind.
Hypothesis suppose_reversed(const JudgedScene& scene, const JudgedPairs& judged);

}  // namespace hottel
