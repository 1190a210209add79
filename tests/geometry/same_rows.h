// Rows that come a range at a time, held against those of a matrix.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "geometry/exchange_matrix.h"
#include "geometry/row_ranges.h"
#include "tests/same_matrix.h"

namespace hottel::testing_scenes {

// An entry with all that is said of it, bit for bit.
inline bool is_same_entry(const ExchangeMatrix& a, const ExchangeMatrix& b, std::uint32_t row, std::size_t k) {
  const FactorEntry x = a.row(row)[k], y = b.row(row)[k];
  const Enclosure p = a.bounds(row, k), q = b.bounds(row, k);
  return x.to == y.to && is_same(x.factor.value, y.factor.value) && x.factor.side == y.factor.side &&
         is_same(x.visibility, y.visibility) && is_same(p.lower, q.lower) && is_same(p.upper, q.upper) &&
         a.guarantee(row, k) == b.guarantee(row, k);
}

// All rows are there, in their order, bit for bit.
inline void expect_same_rows(const ExchangeMatrix& whole, RowRanges& rows) {
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < rows.count(); ++k) {
    const RowRange range = rows.load(k);
    EXPECT_EQ(range.first, next);
    for (std::uint32_t row = range.first; row < range.end; ++row) {
      ASSERT_EQ(rows.matrix().row(row).size(), whole.row(row).size()) << whole.name(row);
      std::size_t different = 0;
      for (std::size_t n = 0; n < whole.row(row).size(); ++n)
        different += is_same_entry(whole, rows.matrix(), row, n) ? 0 : 1;
      EXPECT_EQ(different, 0U) << whole.name(row);
    }
    next = range.end;
  }
  EXPECT_EQ(next, whole.size());
  EXPECT_TRUE(std::ranges::equal(rows.begins(), whole.begins()));
}

}  // namespace hottel::testing_scenes
