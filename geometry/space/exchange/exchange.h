// View factors of a scene in space.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_request.h"
#include "geometry/row_ranges.h"
#include "geometry/space/exchange/exchange_report.h"

namespace hottel {

struct PreparedScene3;

// Returns the view factors of all pairs that exchange light, each with proven bounds.
//
//   (1) the real F_ij lies within its bounds. Where they are within the tolerance of the request, which is on S
//   relative to the
//       smaller area, the entry is kEnclosed; else kEstimated: |F A_i - S|, of the double F, is then estimated, not
//       proven, to be at most the tolerance times that area
//   (2) no entry iff the real view factor is 0; this is decided by signs
//   (3) both entries of a pair come from one measure, and so do their bounds; every row sums to 1 within the errors of
//       its entries, the sky included
//   (4) Vis(i, j) is the quotient of two measures, below 1 whenever something hides a part, above 0 always, and 1
//       exactly when nothing does (of two groups it may be told as next to 1 where something stands between that hides
//       only what they hide themselves)
//   (5) the result is the same bit for bit for any number of threads
//   (6) with the sky by closure, F(i, sky) is 1 minus the other factors of the row; its bounds follow from theirs, and
//       its error is up to the sum of theirs. Other entries have the same bits. The sky is integrated as usual in rows
//       that are checked, and in those whose rest is no more than what their pairs may be off in all (SkyByClosure)
//
// Throws UnmeasuredPairs naming the first pairs where some could not be measured, RequestError where a row that is
// checked differs from its rest by more than its pairs may be off, and when the memory allowed
// by the request does not suffice; passes on what `progress` throws. COST: parallel. 10 to 50 microseconds a clear
// pair, some 0.3 ms a pair that surfaces stand between.
ExchangeMatrix exact_exchange(const PreparedScene3& prepared, const ExchangeRequest& request = {},
                              ExchangeReport3* report = nullptr);

// Returns the pairs (from, to) that are hidden: `from` has a row without an entry for `to`, but they would exchange
// light if everything else were taken away (S = 0 < S0). Of the rows that are chosen.
//
//   (1) sorted by `from`, then by `to`, the sky last
//   (2) (i, j) and (j, i) are both in the list where both have rows
//   (3) (i, sky) is in the list wherever i does not see the sky
//
// REQUIRES: the matrix of the scene by exact_exchange, of this granularity, with the rows that are chosen at least.
// COST: every pair is looked at; pairs of groups are measured.
std::vector<ElementPair> hidden_pairs(const PreparedScene3& prepared, Granularity granularity,
                                      const ExchangeMatrix& matrix, const RowChoice& chosen = {});

// Throws RequestError, telling how many pairs have no enclosure and naming the first of them, unless all have.
void require_enclosed_3(const ExchangeMatrix& matrix, double tolerance);
// The same of rows.
void require_enclosed_3(RowRanges& rows, double tolerance);

}  // namespace hottel
