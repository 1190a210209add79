// The direct exchange areas of all pairs of elements.
#pragma once

#include <cstdint>

#include "geometry/space/exchange/exchange_report.h"
#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// Measures all pairs of patches of which at least one is of an element with a row, and sums them by elements.
//
//   (1) a pair is there iff S > 0; of groups with visibilities also where S = 0 < S0 of some patches: then S = 0
//   (2) the same bit for bit for any number of threads: patches are summed in their order
//   (3) a pair (i, i), of a group, counts both directions of a line
//   (4) contacts of masks are pairs like others: whole, and as large as what they share
//   (5) adds to the hidden, clear and mixed pairs, the maps, pieces, nodes and signs of the report
//   (6) each pair of patches has its share of the tolerance (PairShares3). Where one could not be held, more is tried
//       only if all patches of both elements together are not within the tolerance; if they are not then either, the
//       pair has failed, and is told once
//   (7) the same bit for bit whoever takes part (PairCrew3). Each task is done once: else ContractViolation
//
// Throws Interrupted where it is asked to stop.
// COST: parallel; that of measuring each pair of faces that face each other, and 50 ns for each other pair.
PairSums3 sum_pairs(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request,
                    ExchangeReport3& report);

// Returns about how many pairs of patches exchange light, from 512 drawn by a fixed seed and measured. The same scene
// always gives the same estimate. It may be wrong either way.
std::uint64_t estimated_pairs(const PreparedScene3& prepared, const ElementTable3& table);

}  // namespace hottel
