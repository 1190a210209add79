// Which pairs of elements are known: by row, ranges of columns.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hottel {

// Columns from begin up to, and without, end.
struct ColumnRange {
  std::uint32_t begin = 0, end = 0;
  friend bool operator==(const ColumnRange&, const ColumnRange&) = default;
};

// A set of pairs (i, j), i <= j, of n elements; j = n is the sky.
//
//   (1) ranges of a row ascend, do not meet, and none is empty
//   (2) rows beside ranges(i) are its complement: together they are the columns from i to the sky, each once
// COST: 8 bytes a range; a question is a binary search.
class PairRanges {
 public:
  PairRanges() = default;
  // No pair of so many elements.
  explicit PairRanges(std::uint32_t elements) : rows_(elements), elements_(elements) {}

  std::uint32_t elements() const { return elements_; }
  // REQUIRES i < elements(), i <= j <= elements().
  bool has(std::uint32_t i, std::uint32_t j) const;
  // Adds columns of a row. Throws ContractViolation unless i <= begin < end <= elements() + 1.
  void add(std::uint32_t i, ColumnRange columns);

  std::span<const ColumnRange> ranges(std::uint32_t i) const { return rows_[i]; }
  std::vector<ColumnRange> missing(std::uint32_t i) const;
  // True iff no pair is missing.
  bool has_all() const;

 private:
  std::vector<std::vector<ColumnRange>> rows_;
  std::uint32_t elements_ = 0;
};

}  // namespace hottel
