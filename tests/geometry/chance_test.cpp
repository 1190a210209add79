#include "geometry/generate/chance.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace hottel::chance_test {
namespace {

TEST(Chance, IsTheSameOnEveryMachine) {
  Chance chance(7);
  EXPECT_EQ(chance.between(-5, 5), 3);
  EXPECT_EQ(chance.below(1'000'000), 949301u);
}

TEST(Chance, StaysWithinItsBoundsAndReachesThem) {
  Chance chance(1);
  std::set<std::int64_t> numbers;
  for (int k = 0; k < 1000; ++k) numbers.insert(chance.between(-3, 3));
  EXPECT_EQ(*numbers.begin(), -3);
  EXPECT_EQ(*numbers.rbegin(), 3);
  EXPECT_EQ(numbers.size(), 7u);
}

TEST(Chance, DrawsNumbersWithoutRepeatingOne) {
  Chance chance(3);
  const auto numbers = drawn(40, 50, chance);
  const std::set<std::int64_t> different(numbers.begin(), numbers.end());
  EXPECT_EQ(numbers.size(), 40u);
  EXPECT_EQ(different.size(), 40u);
  EXPECT_GE(*different.begin(), 0);
  EXPECT_LT(*different.rbegin(), 50);
  EXPECT_EQ(drawn(0, 5, chance).size(), 0u);
}

TEST(IntegerRoot, IsExact) {
  for (const std::uint64_t value : {0ull, 1ull, 3ull, 4ull, 99ull, 100ull, 1ull << 62}) {
    const std::uint64_t root = integer_root(value);
    EXPECT_LE(root * root, value);
    EXPECT_GT((root + 1) * (root + 1), value);
  }
  EXPECT_EQ(integer_root(std::numeric_limits<std::uint64_t>::max()), (1ull << 32) - 1);
}

TEST(SideOfSquareAndCube, AreTheLeastThatSuffice) {
  for (std::int64_t value = 1; value <= 1000; ++value) {
    const std::int64_t square = side_of_square(static_cast<std::uint64_t>(value));
    EXPECT_GE(square * square, value);
    EXPECT_LT((square - 1) * (square - 1), value);
    const std::int64_t cube = side_of_cube(static_cast<std::uint64_t>(value));
    EXPECT_GE(cube * cube * cube, value);
    EXPECT_LT((cube - 1) * (cube - 1) * (cube - 1), value);
  }
  EXPECT_EQ(side_of_square(0), 0);
  EXPECT_EQ(side_of_cube(0), 0);
}

}  // namespace
}  // namespace hottel::chance_test
