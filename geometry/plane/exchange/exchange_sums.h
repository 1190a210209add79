// Twice the direct exchange areas of all visible pairs, in fixed point: sums that do not depend on the order of
// addition.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/exchange/pair_sums.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// Returns the sums of all pairs for which something was added and at least one of the two has a row. A pair (i, i)
// occurs for groups only and counts both directions of a line.
//
//   (1) the value does not depend on the number of threads: 128-bit integer addition is associative
//   (2) sum over j of value(i, j) == 2 length(i) to the last bit, for every label i that has a row: each length enters
//       a row with coefficients that cancel, but for the lengths on i itself
// COST: parallel; one sweep about each of the swept_vertices(), and 32 bytes a term in flight, 43 to 85 bytes a pair,
// and 32 in the end.
// `progress` is called from time to time with the fraction done and may throw to stop.
//
// Throws RequestError when the pairs become more than `most_pairs`. parts: as of sum_terms(), in the order of
// swept_vertices().
PairSums2 sum_visible_pairs(const Arrangement2& arrangement, const ElementTable2& table,
                            const std::function<void(double)>& progress, std::uint64_t most_pairs, SumCounts2& counts,
                            SweepParts2* parts = nullptr);

// The same of the gaps that start at some vertices alone: where each of the swept_vertices() is in one call, the sums
// of all calls add up to those of all. parts, work: as of sum_terms(), in this order.
PairSums2 sum_pairs_about(std::span<const VertexId> order, const Arrangement2& arrangement, const ElementTable2& table,
                          const std::function<void(double)>& progress, std::uint64_t most_pairs, SumCounts2& counts,
                          SweepParts2* parts = nullptr, SharedWork<SweptPart2>* work = nullptr);

// What a visible pair takes in memory at the most, from the sums to the matrix, in bytes (measured on clutter with
// backs, where both directions have a row; benchmarks/factors).
inline constexpr std::uint64_t kBytesPerPair = 200;

// What the sweeps about some vertices tell of a scene.
struct SightEstimate2 {
  std::uint64_t pairs = 0;  // about so many see each other
  double seen = 0;          // vertices seen from a vertex, on average
  double seen_typed = 0;    // of these, ends of edges as they were typed
};

// Estimates from `most` vertices drawn by a fixed seed, or from all of them where there are fewer. The same scene
// always gives the same estimate. It may be wrong either way.
SightEstimate2 estimated_sight(const Arrangement2& arrangement, const ElementTable2& table, std::uint64_t most = 256);

// Checks property (2) of sum_visible_pairs as an identity of integers. Returns the largest defect of a row, in units
// of Vertices2::fixed_unit(): 0 when it holds.
Int128 closure_defect(const PairSums2& sums, const ElementTable2& table);

}  // namespace hottel
