// Rows that come a range at a time, held against those of a matrix.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/exchange/exact_rows.h"

namespace hottel::testing_scenes {

inline bool is_same_entry(const FactorEntry& a, const FactorEntry& b) {
  return a.to == b.to && a.factor.value == b.factor.value && a.factor.side == b.factor.side &&
         (a.visibility == b.visibility || (std::isnan(a.visibility) && std::isnan(b.visibility)));
}

// All rows are there, in their order, bit for bit.
inline void expect_same_rows(const ExchangeMatrix& whole, ExactRows2& rows) {
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < rows.count(); ++k) {
    const RowRange range = rows.load(k);
    EXPECT_EQ(range.first, next);
    for (std::uint32_t row = range.first; row < range.end; ++row)
      EXPECT_TRUE(std::ranges::equal(rows.matrix().row(row), whole.row(row), is_same_entry)) << whole.name(row);
    next = range.end;
  }
  EXPECT_EQ(next, whole.size());
  EXPECT_TRUE(std::ranges::equal(rows.begins(), whole.begins()));
}

}  // namespace hottel::testing_scenes
