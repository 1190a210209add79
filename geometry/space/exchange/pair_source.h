// Where the sums of pairs in space are while rows are made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "geometry/row_cuts.h"
#include "geometry/space/exchange/exchange_memory.h"
#include "geometry/space/exchange/pair_sum.h"

namespace hottel {

// Sums of pairs of elements, a range of rows at a time.
class PairSource3 {
 public:
  virtual ~PairSource3() = default;

  virtual const RowCuts& cuts() = 0;
  // The pairs of which an element is in range k, ascending by (i, j), each once. A pair whose elements are in two
  // ranges is in both.
  virtual std::vector<PairSum3> pairs(std::size_t k) = 0;
};

// Pairs that come in any order, in parts, while others are still being measured.
class PairKeeper3 : public PairSource3 {
 public:
  // Keeps more, each pair once, one call at a time; cuts() may be others then.
  virtual void keep(std::span<const PairSum3> pairs) = 0;
  // What a pair takes of memory at the most until its row is made, in bytes; 0 where it is kept elsewhere.
  virtual std::uint64_t bytes_per_pair() const = 0;
};

// Pairs that are in memory.
// COST: 57 bytes a pair; of pairs(k) a binary search in each row before the range, and of the first one a sort.
class PairsInMemory3 final : public PairKeeper3 {
 public:
  // At most so many entries are in a range, where rows have about as many each.
  static constexpr std::size_t kEntriesInRange = std::size_t{1} << 18;

  // rows: how many elements there are, the sky aside.
  explicit PairsInMemory3(std::uint32_t rows, std::size_t entries_in_range = kEntriesInRange);

  const RowCuts& cuts() override;
  std::vector<PairSum3> pairs(std::size_t k) override;
  void keep(std::span<const PairSum3> pairs) override;
  std::uint64_t bytes_per_pair() const override { return kBytesPerPair3; }

 private:
  void sort();

  std::uint32_t rows_;
  std::size_t entries_in_range_;
  std::deque<PairSum3> pairs_;
  std::vector<std::size_t> begins_;  // of the pairs (i, j) of each i; empty: not sorted
  RowCuts cuts_;
};

}  // namespace hottel
