#include "kernel/determinant.h"

#include <gtest/gtest.h>

#include <random>

namespace hottel::determinant_test {
namespace {

IntegerVector random_vector(std::mt19937_64& engine, long most_bits) {
  const auto number = [&engine, most_bits]() -> Integer {
    const Integer value = (Integer(engine()) << 64) + Integer(engine());
    const Integer small = value >> static_cast<unsigned long>(128 - static_cast<long>(engine() % most_bits) - 1);
    return engine() % 2 == 0 ? Integer(-small) : small;
  };
  return {number(), number(), number()};
}

bool is_within(double value, const Integer& real, long shift, double error) {
  const Rational difference = Rational(value) - scaled_by_power_of_two(Rational(real), -shift);
  return abs(difference) <= Rational(error);
}

TEST(BoundedVector, HoldsTheRoundedIntegers) {
  std::mt19937_64 engine(1);
  for (int n = 0; n < 2000; ++n) {
    const IntegerVector a = random_vector(engine, 120);
    const long shift = static_cast<long>(engine() % 200);
    const BoundedVector r = rounded(a, shift);
    EXPECT_TRUE(is_within(r.x, a.x, shift, r.error) && is_within(r.y, a.y, shift, r.error) &&
                is_within(r.z, a.z, shift, r.error));
    EXPECT_LE(std::fabs(r.x), r.size);
  }
}

// As long as they may be.
TEST(RoundedQuotient, IsThatOfTheIntegers) {
  std::mt19937_64 engine(3);
  for (int n = 0; n < 2000; ++n) {
    const Integer a = random_vector(engine, 120).x, b = abs(random_vector(engine, 120).x) + 1;
    const long shift = static_cast<long>(engine() % 200);
    const unsigned long more = n % 2 == 0 ? 0 : 3000 + engine() % 3000;
    const double quotient = rounded_quotient(a << more, b << more, shift);
    const Rational real = scaled_by_power_of_two(Rational(a) / b, -shift);
    EXPECT_LE(abs(Rational(quotient) - real), scaled_by_power_of_two(abs(real), -50));
    EXPECT_EQ(rounded_quotient(a << more, b, shift + static_cast<long>(more)), quotient);
  }
  EXPECT_EQ(rounded_quotient(0, 7, -5000), 0);
}

TEST(BoundedVector, CrossProductsAreWithinTheirBounds) {
  std::mt19937_64 engine(2);
  for (int n = 0; n < 5000; ++n) {
    const IntegerVector a = random_vector(engine, n % 2 == 0 ? 30 : 120);
    // Half of them nearly parallel, where most digits cancel.
    IntegerVector b = random_vector(engine, 30);
    if (n % 4 > 1) b = {a.x + b.x % 3, a.y + b.y % 3, a.z + b.z % 3};
    const BoundedVector c = cross(rounded(a, 0), rounded(b, 0));
    const IntegerVector exact = cross(a, b);
    EXPECT_TRUE(is_within(c.x, exact.x, 0, c.error) && is_within(c.y, exact.y, 0, c.error) &&
                is_within(c.z, exact.z, 0, c.error));
  }
}

TEST(FilteredSign, CoversDecidedZeroAndUndecided) {
  const BoundedVector x = rounded({3, 0, 0}, 0), y = rounded({0, 5, 0}, 0);
  EXPECT_EQ(filtered_sign(x, x), 1);
  EXPECT_EQ(filtered_sign(x, rounded({-1, 7, 7}, 0)), -1);
  EXPECT_EQ(filtered_sign(x, y), 0);  // small integers
  const Integer large = Integer(1) << 60;
  EXPECT_EQ(filtered_sign(rounded({large, large, 0}, 0), rounded({-large, large + 1, 0}, 0)), kUndecided);
  EXPECT_EQ(filtered_sign(rounded({1, 0, 0}, 900), rounded({1, 0, 0}, 900)), kUndecided);  // underflow
}

TEST(FilteredSign, IsNeverWrong) {
  std::mt19937_64 engine(3);
  int undecided = 0;
  for (int n = 0; n < 20000; ++n) {
    const IntegerVector a = random_vector(engine, 100), b = random_vector(engine, 100);
    IntegerVector c = random_vector(engine, 100);
    // Two thirds in the plane of a and b, or next to it.
    if (n % 3 != 0) {
      const Integer s = 1 + static_cast<int>(engine() % 5), t = 1 + static_cast<int>(engine() % 5);
      c = {a.x * s + b.x * t, a.y * s + b.y * t, a.z * s + b.z * t + static_cast<int>(n % 3 - 1)};
    }
    const int sign = filtered_sign(cross(rounded(a, 0), rounded(b, 0)), rounded(c, 0));
    undecided += sign == kUndecided;
    EXPECT_TRUE(sign == kUndecided || sign == determinant_sign(a, b, c));
  }
  EXPECT_GT(undecided, 1000);
  EXPECT_LT(undecided, 15000);
}

TEST(IntegerVector, PrimitiveKeepsTheDirection) {
  EXPECT_EQ(primitive({6, -9, 0}), (IntegerVector{2, -3, 0}));
  EXPECT_EQ(primitive({0, 0, 0}), (IntegerVector{0, 0, 0}));
  EXPECT_EQ(determinant_sign({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(determinant_sign({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
}

}  // namespace
}  // namespace hottel::determinant_test
