// Sums of products in 192 bits against big numbers.
#include "kernel/wide_sum.h"

#include <gtest/gtest.h>

#include <random>

namespace hottel::wide_sum_test {
namespace {

// A number of at most so many bits, of both signs.
Int128 number(std::mt19937_64& random, int bits) {
  const UInt128 any = (static_cast<UInt128>(random()) << 64) | random();
  const auto magnitude = static_cast<Int128>(any >> (128 - bits));
  return random() % 2 == 0 ? magnitude : -magnitude;
}

void expect(const WideSum& sum, const Integer& exact) {
  Integer result = 7;
  sum.set(result);
  EXPECT_EQ(result, exact);
  EXPECT_EQ(sum.sign(), sgn(exact));
}

TEST(WideSum, IsThatOfBigNumbers) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    WideSum sum;
    Integer exact = 0;
    for (int term = 0; term < 1 + k % 12; ++term) {
      const Int128 a = number(random, 1 + static_cast<int>(random() % 124));
      const auto b = static_cast<std::int64_t>(number(random, 1 + static_cast<int>(random() % 53)));
      sum.add(a, b);
      exact += to_integer(a) * to_integer(b);
      expect(sum, exact);
    }
  }
}

TEST(WideSum, CancelsToZeroAndToOne) {
  std::mt19937_64 random(2);
  for (int bits = 1; bits <= 124; ++bits) {
    const Int128 a = number(random, bits);
    const auto b = static_cast<std::int64_t>(number(random, 53));
    WideSum sum;
    sum.add(a, b);
    sum.add(-a, b);
    expect(sum, 0);
    sum.add(-1, 1);
    expect(sum, -1);
    sum.add(1, 2);
    expect(sum, 1);
  }
}

TEST(WideSum, HoldsNinetyNineOfTheLargest) {
  for (const std::int64_t b : {std::int64_t{1} << 53, -(std::int64_t{1} << 53)}) {
    const Int128 a = (static_cast<Int128>(1) << 124) - 1;
    WideSum sum;
    Integer exact = 0;
    for (int k = 0; k < 99; ++k) {
      sum.add(a, b);
      exact += to_integer(a) * to_integer(b);
    }
    expect(sum, exact);
  }
}

}  // namespace
}  // namespace hottel::wide_sum_test
