// The sweep of the exact method in other arithmetic: any orientations, lengths and sums in plain doubles.
#pragma once

#include <limits>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/exchange/gap_terms.h"
#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

using PlainSums2 = std::vector<std::vector<PlainTerm2>>;  // sorted by key, one partition after the other

// The sweep of the exact method in doubles, with whatever answers for signs and lengths: what exactness costs is the
// difference of two runs.
//
//   (1) with exact signs every sum is that of exact_exchange but for the roundings of lengths and additions
//   (2) with signs that are wrong it ends all the same; pairs may then be missing, or come out negative
//   (3) the same for any number of threads, bit for bit
//
// Returns 2 S(i, j) in the unit of the lengths. points_at(v) answers for the sweep about v: orientation(i, j, k), and
// distance(i, j) as a double. progress: as of sum_terms(). The triangulation is the exact one, whoever answers.
template <class PointsAt>
PlainSums2 plain_sums(const Arrangement2& arrangement, const ElementTable2& table,
                      const std::function<void(double)>& progress, const PointsAt& points_at) {
  const auto sweep = [&](VertexId v, TermBuffer2<PlainTerm2>& out) {
    thread_local View2 view;
    auto&& points = points_at(v);
    look_around(points, arrangement.triangulation(), v, view);
    for_each_gap(points, v, view, true, [&](const Gap2& gap) {
      ++out.gaps;
      double length = -1;
      for_each_term(gap, table, [&](std::uint32_t i, std::uint32_t j, int sign) {
        if (length < 0) length = points.distance(gap.v, gap.w);
        ++out.updates;
        out.add({pair_key(i, j), sign * (i == j ? 2 : 1) * length});
      });
    });
  };
  SumCounts2 counts;
  return sum_terms<PlainTerm2>(arrangement.triangulation().sweep_order(), table.covered() + std::size_t{1}, sweep,
                               progress, std::numeric_limits<std::uint64_t>::max(), counts);
}

// Returns the length of each element, in the unit of points.distance(i, j).
template <class Points>
std::vector<double> plain_lengths(const Arrangement2& arrangement, const ElementTable2& table, const Points& points) {
  std::vector<double> lengths(table.count(), 0);
  for (const PieceSideId side : arrangement.sides()) {
    const std::uint32_t label = table.of(side);
    if (label == table.covered()) continue;
    const Segment2& piece = arrangement.piece(side);
    lengths[label] += points.distance(piece.a, piece.b);
  }
  return lengths;
}

// Returns F_ij = 2 S(i, j) / (2 A_i) for all sums that are not zero.
//
//   (1) both factors of a pair come from one sum: A_i F_ij = A_j F_ji but for the roundings of the quotients
//   (2) an element whose length came out as zero has an empty row
ExchangeMatrix plain_matrix(const ElementTable2& table, const PlainSums2& sums, const std::vector<double>& lengths);

}  // namespace hottel
