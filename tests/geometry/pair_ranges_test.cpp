#include "geometry/pair_ranges.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "kernel/support/failure.h"

namespace hottel::pair_ranges_test {
namespace {

TEST(PairRanges, AreTheSetOfWhatWasAdded) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 300; ++round) {
    const auto n = static_cast<std::uint32_t>(1 + random() % 12);
    PairRanges ranges(n);
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (int k = 0; k < 40; ++k) {
      const auto i = static_cast<std::uint32_t>(random() % n);
      const auto begin = static_cast<std::uint32_t>(i + random() % (n + 1 - i));
      const auto end = static_cast<std::uint32_t>(begin + 1 + random() % (n + 1 - begin));
      ranges.add(i, {begin, end});
      for (std::uint32_t j = begin; j < end; ++j) pairs.emplace(i, j);
      std::size_t all = 0;
      for (std::uint32_t row = 0; row < n; ++row) {
        std::vector<char> there(n + 1, 0);
        std::uint32_t last = 0;
        for (const ColumnRange& range : ranges.ranges(row)) {  // (1)
          EXPECT_LT(range.begin, range.end);
          EXPECT_TRUE(last == 0 || range.begin > last);
          last = range.end;
          for (std::uint32_t j = range.begin; j < range.end; ++j) ++there[j];
        }
        for (const ColumnRange& range : ranges.missing(row))  // (2)
          for (std::uint32_t j = range.begin; j < range.end; ++j) there[j] = static_cast<char>(there[j] + 2);
        for (std::uint32_t j = row; j <= n; ++j, ++all) {
          EXPECT_EQ(ranges.has(row, j), pairs.contains({row, j}));
          EXPECT_EQ(there[j], pairs.contains({row, j}) ? 1 : 2);
        }
      }
      EXPECT_EQ(ranges.has_all(), pairs.size() == all);
    }
  }
}

TEST(PairRanges, RefuseWhatIsNoPartOfARow) {
  PairRanges ranges(3);
  EXPECT_THROW(ranges.add(1, {0, 2}), ContractViolation);
  EXPECT_THROW(ranges.add(1, {2, 2}), ContractViolation);
  EXPECT_THROW(ranges.add(1, {2, 5}), ContractViolation);
  EXPECT_THROW(ranges.add(3, {3, 4}), ContractViolation);
}

}  // namespace
}  // namespace hottel::pair_ranges_test
