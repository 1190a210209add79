// The sums of all pairs by rows, and where the entries of each pair stand in a matrix.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// 2 S(i, j) of pairs of labels, by rows: each stands in the row of the smaller of the two.
//
//   (1) a row ascends by the greater label
// COST: the sums stay where they are; 24 bytes a row.
class PairSums2 {
 public:
  // REQUIRES: the parts, one after another, ascend by key; no row stands in two of them; smaller labels are below rows.
  PairSums2(std::vector<std::vector<PairSum2>> parts, std::uint32_t rows);
  PairSums2(const PairSums2&) = delete;
  PairSums2(PairSums2&&) = default;

  std::uint32_t rows() const { return static_cast<std::uint32_t>(rows_.size()); }
  std::span<const PairSum2> row(std::uint32_t i) const { return rows_[i]; }
  // How many pairs stand in the rows before row i; of all pairs where i is rows().
  std::size_t before(std::uint32_t i) const { return before_[i]; }
  std::size_t size() const { return before_.back(); }
  // Calls visit(const PairSum2&) for all pairs, row by row.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const std::span<const PairSum2>& row : rows_)
      for (const PairSum2& sum : row) visit(sum);
  }

 private:
  std::vector<std::vector<PairSum2>> parts_;
  std::vector<std::span<const PairSum2>> rows_;
  std::vector<std::size_t> before_;
};

// The places of F(i, j) and F(j, i) in the rows of a matrix, for the k-th pair of all.
//
//   (1) the entries of row r take the places begin()[r] to begin()[r + 1], ascending by column
//   (2) only labels that have a row have entries; a pair (i, i) has one
// COST: 4 bytes a pair.
class EntryPlaces2 {
 public:
  // REQUIRES: the sums outlive this.
  EntryPlaces2(const PairSums2& sums, const ElementTable2& table);

  const std::vector<std::size_t>& begin() const { return begin_; }
  std::size_t row_size(std::uint32_t label) const { return begin_[label + 1] - begin_[label]; }
  // REQUIRES: i has a row, and pair k stands in row i of the sums.
  std::size_t forth(std::uint32_t i, std::size_t k) const { return begin_[i] + back_entries_[i] + k - sums_.before(i); }
  // REQUIRES: j has a row, j > i.
  std::size_t back(std::uint32_t j, std::size_t k) const { return begin_[j] + back_[k]; }

 private:
  const PairSums2& sums_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> back_entries_;  // of each row: entries of smaller labels, before all others
  std::vector<std::uint32_t> back_;          // of each pair: its place among these
};

}  // namespace hottel
