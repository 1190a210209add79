// What a file of HDF5 must have of a table of factors.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "io/files/hdf5.h"
#include "io/results/listed_factors.h"

namespace hottel {

// Entries, bounds and guarantees of a file as the list of the table has them.
inline void expect_as_listed(const std::string& bytes, const FactorTable& table) {
  const Hdf5Reader file("f.h5", bytes);
  const auto begin = file.whole_numbers("begin"), column = file.whole_numbers("column");
  const auto factor = file.numbers("factor"), code = file.numbers("guarantee");
  const bool has_bounds = file.has("lower");
  const auto lower = has_bounds ? file.numbers("lower") : factor, upper = has_bounds ? file.numbers("upper") : factor;
  std::size_t k = 0;
  for_each_listed(table,
                  [&](std::uint32_t from, const FactorEntry& entry, const Enclosure& bounds, Guarantee guarantee) {
                    ASSERT_LT(k, factor.size());
                    EXPECT_TRUE(begin[from] <= k && k < begin[from + 1]);
                    EXPECT_EQ(column[k], entry.to);
                    EXPECT_EQ(factor[k], entry.factor.value);
                    if (guarantee == Guarantee::kExact)
                      EXPECT_EQ((Rounded{factor[k], static_cast<signed char>(code[k])}).enclosure(), bounds);
                    else
                      EXPECT_EQ(code[k], guarantee == Guarantee::kEnclosed ? 2 : 3);
                    if (has_bounds) {
                      EXPECT_EQ((Enclosure{lower[k], upper[k]}), bounds);
                    }
                    ++k;
                  });
  EXPECT_EQ(k, factor.size());
}

}  // namespace hottel
