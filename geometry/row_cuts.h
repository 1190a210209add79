// All rows of a matrix, cut into ranges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/row_ranges.h"

namespace hottel {

// The rows of labels cut into ranges of about as many rows each.
//
//   (1) ranges follow each other, and together they are all rows; none of several is empty
class RowCuts {
 public:
  // REQUIRES: ranges >= 1. There are no more than rows, and one at least.
  RowCuts(std::uint32_t rows, std::size_t ranges);

  std::size_t count() const { return ends_.size(); }
  RowRange range(std::size_t k) const { return {k == 0 ? 0 : ends_[k - 1], ends_[k]}; }
  // The range of a row. REQUIRES: a row.
  std::size_t of(std::uint32_t row) const;

 private:
  std::vector<std::uint32_t> ends_;
};

}  // namespace hottel
