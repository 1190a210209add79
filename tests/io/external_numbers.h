// Matrices of numbers as others write them, and as they are to be read.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// Equal factors in all columns but those that are left out, which are empty.
inline void expect_same(
    const ExchangeMatrix& matrix, const ExchangeMatrix& exact, double relative = 0,
    const std::function<bool(std::uint32_t)>& is_there = [](std::uint32_t) { return true; }) {
  ASSERT_EQ(matrix.size(), exact.size());
  EXPECT_EQ(matrix.guarantee(), Guarantee::kEstimated);
  std::size_t compared = 0;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (std::uint32_t j = 0; j <= exact.sky(); ++j) {
      const double expected = is_there(j) ? exact.factor(i, j).value : 0;
      EXPECT_NEAR(matrix.factor(i, j).value, expected, relative * expected) << i << " " << j;
      compared += expected != 0;
    }
  }
  EXPECT_EQ(matrix.entry_count(), compared);
  EXPECT_GT(compared, 0u);
}

// A 4 x 4 matrix of distinct numbers, small enough for float32 to hold them.
inline double number(std::uint32_t i, std::uint32_t j) { return i == j ? 0 : (4 * i + j) / 64.0; }

inline ExchangeMatrix numbers_in_order(const PreparedScene2& prepared) {
  ExchangeMatrix matrix(exact_exchange(prepared).elements(), Guarantee::kEstimated);
  std::vector<std::size_t> begin(9, 0);
  std::vector<FactorEntry> entries;
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (std::uint32_t j = 0; j < 4 && i % 2 == 0; ++j)
      if (i != 2 * j) entries.push_back({2 * j, {number(i / 2, j), 0}, 1});
    begin[i + 1] = entries.size();
  }
  matrix.assign(std::move(begin), std::move(entries));
  return matrix;
}

inline std::string numpy_head(const std::string& type, bool is_fortran, const std::string& shape, int version = 1) {
  const std::string head =
      "{'descr': '" + type + "', 'fortran_order': " + (is_fortran ? "True" : "False") + ", 'shape': (" + shape + ")}\n";
  std::string text = "\x93NUMPY" + std::string{static_cast<char>(version), 0};
  for (int k = 0; k < (version == 1 ? 2 : 4); ++k) text += static_cast<char>(k == 0 ? head.size() : 0);
  return text + head;
}

template <class Number>
std::string numpy(const std::string& type, bool is_fortran, std::uint32_t rows, std::uint32_t columns,
                  const std::function<double(std::uint32_t, std::uint32_t)>& value, int version = 1) {
  std::string text = numpy_head(type, is_fortran, std::to_string(rows) + ", " + std::to_string(columns) + ",", version);
  const std::uint32_t outer = is_fortran ? columns : rows, inner = is_fortran ? rows : columns;
  for (std::uint32_t a = 0; a < outer; ++a)
    for (std::uint32_t b = 0; b < inner; ++b) {
      const auto number = static_cast<Number>(is_fortran ? value(b, a) : value(a, b));
      text.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  return text;
}

}  // namespace hottel
