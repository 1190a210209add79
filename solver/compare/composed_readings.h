// Several faults at once: a rule for the factors, a visibility, an order of the indices, a constant, the scatter of
// rays.
#pragma once

#include <optional>
#include <vector>

#include "solver/compare/hypotheses.h"
#include "solver/compare/judged_pairs.h"
#include "solver/compare/judged_scene.h"

namespace hottel {

enum class Orders : unsigned char { kRight, kAny };

inline constexpr double kLeastShareOfComposed = 0.95;  // of the pairs off, and of all that a reading predicts

// Returns the cheapest reading that applies several faults to every pair, or one that no other hypothesis knows, and
// explains kLeastShareOfComposed of the pairs that are off. Nothing where there is none.
//
// value(i, j) is held against c m R(p, q) V(p, q), where
//   R   is the factor without obstacles: the true one (price 0), or what a PointRule gives (2)
//   V   is the true visibility (0), 0 or 1 where a part is hidden (1), or 1 everywhere (1)
//   p, q, m  are i, j, 1 (0); j, i, 1: transposed (1); i, j and a product of powers of the two areas (2); or another
//       order of rows and columns (2: those of suppose_permuted() and its like)
//   c   is 1 (0), a constant with a name (1), or any (2); the median of the ratios
//
//   (1) nothing is claimed that was not applied: a pair counts as explained only where its value agrees with the
//       prediction, and as many pairs as are off by less than 1 in 20 may disagree, those that are right included; of
//       those that nothing would hide 1 in 20 may be 0
//   (2) it rests on kFewestValues different numbers or more
//   (3) of readings that explain equally much the one of the lowest price is returned
//   (4) the sky is no evidence. What goes there agrees with the exact factor, the same times c, 0, or the rest of the
//       row
// orders: kAny asks for other orders of rows and columns too, which takes longest.
// Beyond kMostApproximated elements only true factors that something hides are asked for. COST: each reading is tried
// on 2,000 pairs, and on all where these agree.
std::optional<Hypothesis> suppose_composed(const JudgedScene& scene, const JudgedPairs& judged,
                                           const std::vector<double>& unobstructed, Orders orders);

inline constexpr std::size_t kFewestValues = 8;

}  // namespace hottel
