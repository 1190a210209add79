// Matrices that are the same, for tests.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/exchange_matrix.h"

namespace hottel {

inline bool is_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

// Everything that a matrix says, bit for bit.
inline void expect_same(const ExchangeMatrix& a, const ExchangeMatrix& b) {
  ASSERT_EQ(a.size(), b.size());
  ASSERT_EQ(a.entry_count(), b.entry_count());
  EXPECT_EQ(a.guarantee(), b.guarantee());
  std::size_t different = 0;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.row(i).size(), b.row(i).size());
    ASSERT_EQ(a.measures(i).size(), b.measures(i).size());
    EXPECT_EQ(a.elements()[i].name, b.elements()[i].name);
    for (std::size_t k = 0; k < a.row(i).size(); ++k) {
      const FactorEntry &x = a.row(i)[k], &y = b.row(i)[k];
      const Enclosure p = a.bounds(i, k), q = b.bounds(i, k);
      different += x.to != y.to || !is_same(x.factor.value, y.factor.value) || x.factor.side != y.factor.side ||
                   !is_same(x.visibility, y.visibility) || !is_same(p.lower, q.lower) || !is_same(p.upper, q.upper) ||
                   a.guarantee(i, k) != b.guarantee(i, k) ||
                   (!a.measures(i).empty() && !is_same(a.measures(i)[k], b.measures(i)[k]));
    }
  }
  EXPECT_EQ(different, 0U);
}

}  // namespace hottel
