// The rows of a matrix of view factors that is never there as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "geometry/exchange_matrix.h"
#include "kernel/support/folder_memory.h"

namespace hottel {

// Rows from `first` up to `end`.
struct RowRange {
  std::uint32_t first = 0, end = 0;

  static constexpr RowRange all() { return {0, std::numeric_limits<std::uint32_t>::max()}; }
  bool has(std::uint32_t row) const { return first <= row && row < end; }
};

// A matrix of which one range of rows is there at a time.
//
//   (1) ranges follow each other, and together they are all rows; each may be loaded any number of times
//   (2) begins(), known before any is loaded, says where each row begins among the entries of all, as begins() of the
//       whole matrix
class RowRanges {
 public:
  virtual ~RowRanges() = default;

  virtual std::size_t count() const = 0;
  virtual std::span<const std::size_t> begins() const = 0;
  // The elements, and the entries of the rows that were loaded last; all other rows have none.
  virtual const ExchangeMatrix& matrix() const = 0;
  // Fills the matrix with range k, and returns which rows these are.
  virtual RowRange load(std::size_t k) = 0;
};

// Returns all rows as one matrix, whose entries stand in `memory`; null for the heap. Besides these one range is there
// at a time. REQUIRES: entries without measures and bounds.
ExchangeMatrix whole_matrix(RowRanges& rows, const std::shared_ptr<const FolderMemory>& memory);

}  // namespace hottel
