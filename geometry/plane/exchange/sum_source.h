// Where the sums of pairs are while rows are made of them.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/exchange/pair_sums.h"
#include "geometry/row_cuts.h"

namespace hottel {

// 2 S(i, j) of pairs of labels, a range of rows at a time.
class SumSource2 {
 public:
  virtual ~SumSource2() = default;

  virtual const RowCuts& cuts() const = 0;
  // The sums of all pairs of which a label is a row of range k, ascending by key, each once. A pair whose rows are in
  // two ranges is in both.
  virtual std::vector<PairSum2> sums(std::size_t k) const = 0;
};

// Sums that are in memory.
// COST of sums(): a binary search in each row before the range, and 32 bytes for each of its pairs.
class SumsInMemory2 final : public SumSource2 {
 public:
  // At most so many entries are in a range, where rows have about as many each.
  static constexpr std::size_t kEntriesInRange = std::size_t{1} << 21;

  explicit SumsInMemory2(PairSums2 sums, std::size_t entries_in_range = kEntriesInRange);

  const RowCuts& cuts() const override { return cuts_; }
  std::vector<PairSum2> sums(std::size_t k) const override;

 private:
  PairSums2 sums_;
  RowCuts cuts_;
};

}  // namespace hottel
