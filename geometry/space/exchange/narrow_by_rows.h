// Bounds of pairs, narrowed by what the others of their rows leave.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"

namespace hottel {

// Narrows the bounds of every pair to what all other pairs of a row leave of the area, for both of its rows: S(i, j) =
// A_i - sum of S(i, k) over all others. Returns how many became narrower.
//
//   (1) once and at the same time: sums are of the bounds as they were
//   (2) measures stay, but for those that are then outside: these are moved to the nearer bound
//   (3) what a sky has by closure alone says nothing new of its row, and nothing is narrowed by it
// REQUIRES all pairs of all elements with rows that are not 0, each within its bounds, those with the sky too. Throws
// ContractViolation, naming a pair, where bounds exclude what the others leave: something was proven that is not so.
std::uint64_t narrow_by_rows(const ElementTable3& table, std::span<PairSum3> pairs);

}  // namespace hottel
