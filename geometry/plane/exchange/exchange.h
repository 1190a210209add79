// Exact view factors of a scene in the plane.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_report.h"
#include "geometry/exchange_request.h"

namespace hottel {

struct PreparedScene2;
struct PairSum2;
template <class Term>
struct SweepParts;  // term_sums.h
using SweepParts2 = SweepParts<PairSum2>;

// Returns the view factors of all pairs that exchange light, each correctly rounded.
//
//   (1) F_ij is the double nearest to the real view factor; its enclosure is at most one ulp wide
//   (2) no entry iff the real view factor is 0; this is decided without rounding
//   (3) A_i F_ij = A_j F_ji for the real numbers, and every row sums to 1, the sky included
//   (4) Vis(i, j) is correctly rounded too, but below 1 whenever something hides a part, and 1 when nothing does
//   (5) the result is the same bit for bit for any number of threads
//   (6) of the rows that are asked for alone: the same, bit for bit; a pair that is in none of them is not summed
//   (7) in a convex room, where nothing can hide anything, no sweep is made unless one is asked for: the result is
//       the same bit for bit
// Throws RequestError when the memory allowed by the request does not suffice, and passes on what `progress` throws.
// The report, where one is asked for, says how the numbers came about. parts: as of sum_visible_pairs(); where no sweep
// is made there are none.
// COST: about 1 µs a visible pair and core; see benchmarks/results.
ExchangeMatrix exact_exchange(const PreparedScene2& prepared, const ExchangeRequest& request = {},
                              ExchangeReport* report = nullptr, SweepParts2* parts = nullptr);

// Returns the pairs (from, to) that are hidden: `from` has a row without an entry for `to`, but they would exchange
// light if everything else were taken away (S = 0 < S0). Of the rows that are chosen.
//
//   (1) sorted by `from`, then by `to`, the sky last
//   (2) (i, j) and (j, i) are both in the list where both have rows
//   (3) (i, sky) is in the list wherever i does not see the sky: S0(i, sky) = A_i, so that Vis(i, sky) = F(i, sky)
//
// REQUIRES: the exact matrix of the scene, of this granularity, with the rows that are chosen at least. COST: every
// pair is looked at.
std::vector<ElementPair> hidden_pairs(const PreparedScene2& prepared, Granularity granularity,
                                      const ExchangeMatrix& matrix, const RowChoice& chosen = {});

}  // namespace hottel
