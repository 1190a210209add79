// Bounds of pairs, narrowed by what the others of their rows leave.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/row_ranges.h"
#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// The bounds of all pairs of each row, summed; and of each pair narrowed to what all other pairs of a row leave of the
// area, for both of its rows: S(i, j) = A_i - sum of S(i, k) over all others.
//
//   (1) once and at the same time: sums are of the bounds as they were
//   (2) measures stay, but for those that are then outside: these are moved to the nearer bound
//   (3) what a sky has by closure alone says nothing new of its row, and nothing is narrowed by it
//   (4) the same bits however rows come in ranges, where pairs of each are in order
class RowBounds3 {
 public:
  // REQUIRES that it outlives this.
  explicit RowBounds3(const ElementTable3& table) : table_(table), rows_(table.count()) {}

  // Adds the pairs of some rows; others may be in the list. REQUIRES all pairs of these rows that are not 0, each
  // within its bounds, those with the sky too.
  void add(const RowRange& rows, std::span<const PairSum3> pairs);
  // Narrows pairs, and returns how many of those (i, j) with i among `rows` became narrower. REQUIRES that all rows
  // were added. Throws ContractViolation, naming a pair, where bounds exclude what the others leave: something was
  // proven that is not so.
  std::uint64_t narrow(const RowRange& rows, std::span<PairSum3> pairs) const;

 private:
  struct RowSum {
    CompensatedSum<double> lower, upper;

    // What all pairs but one leave of the area.
    Enclosure rest_without(const Enclosure& one, const Enclosure& area) const;
  };

  template <class Visit>
  void for_each_row(const PairSum3& pair, const Visit& visit) const {
    if (table_.has_row(pair.i)) visit(pair.i);
    if (pair.j != pair.i && pair.j != table_.sky() && table_.has_row(pair.j)) visit(pair.j);
  }

  const ElementTable3& table_;
  std::vector<RowSum> rows_;
};

}  // namespace hottel
