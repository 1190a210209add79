#include "kernel/rounded_share.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "kernel/nearest_double.h"
#include "kernel/support/failure.h"

namespace hottel::rounded_share_test {
namespace {

// Both doubles next to it are at least as far away, and of two as near the even one is taken: by rationals.
bool is_nearest(double rounded, const Rational& value) {
  const auto distance = [&](double other) { return Rational(abs(Rational(other) - value)); };
  const Rational own = distance(rounded);
  const bool is_even = std::bit_cast<std::uint64_t>(rounded) % 2 == 0;
  for (const double other : {std::nextafter(rounded, -HUGE_VAL), std::nextafter(rounded, HUGE_VAL)})
    if (std::isfinite(other) && (distance(other) < own || (distance(other) == own && !is_even))) return false;
  return true;
}

Integer random_integer(std::mt19937_64& random, std::uint64_t bits) {
  Integer result = 0;
  for (std::uint64_t k = 0; k < bits; ++k) result = 2 * result + static_cast<unsigned long>(random() >> 63);
  return result;
}

TEST(NearestDouble, IsTheNearestWhateverTheCommonFactors) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20'000; ++k) {
    const Integer p = random_integer(random, random() % 200), q = random_integer(random, random() % 200) + 1;
    const Integer factor = random_integer(random, random() % 70) + 1;
    const bool is_negative = random() % 2 == 0;
    Rational value(is_negative ? Integer(-p) : p, q);
    value.canonicalize();
    const double result = nearest_double((is_negative ? -p : p) * factor, q * factor);
    ASSERT_TRUE(is_nearest(result, value)) << value;
    ASSERT_EQ(result, to_double(value));
  }
}

TEST(NearestDouble, TiesGoToTheEvenOne) {
  const Integer two_54 = Integer(1) << 54;
  const double above[] = {0, 0, 0, 4, 4, 4, 8, 8, 8};  // of 2^54, whose doubles are 4 apart
  for (int k = 0; k < 9; ++k) EXPECT_EQ(nearest_double(3 * (two_54 + k), 3), 0x1p54 + above[k]) << k;
}

TEST(NearestDouble, RoundsAtBothEndsOfTheRange) {
  const Integer one = 1;
  const auto power = [](unsigned long exponent) { return Integer(Integer(1) << exponent); };
  EXPECT_EQ(nearest_double(one, power(1074)), 0x1p-1074);
  EXPECT_EQ(nearest_double(one, power(1075)), 0);  // a tie: to the even one
  EXPECT_EQ(nearest_double(power(60) + 1, power(1135)), 0x1p-1074);
  EXPECT_EQ(nearest_double(3, power(1075)), 0x1p-1073);
  EXPECT_TRUE(std::signbit(nearest_double(-one, power(3000))));
  EXPECT_EQ(nearest_double(-one, power(3000)), 0);
  EXPECT_EQ(nearest_double(power(1024) - power(970), one), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest_double(power(1024) - power(970) - 1, one), std::numeric_limits<double>::max());
  EXPECT_EQ(nearest_double(-power(5000), one), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest_double(0, 7), 0);
}

TEST(RoundedShare, IsThatOfRationalArithmetic) {
  std::mt19937_64 random(2);
  const auto rational = [&] {
    Rational value(random_integer(random, random() % 90), random_integer(random, random() % 90) + 1);
    value.canonicalize();
    return random() % 2 == 0 ? value : Rational(-value);
  };
  for (int k = 0; k < 2'000; ++k) {
    const Rational origin = rational(), extent = abs(rational()) + Rational(1) / 1'000;
    const RoundedShare share(origin, extent);
    for (int i = 0; i < 5; ++i) {
      const Rational value = i == 0 ? origin : rational();
      ASSERT_EQ(std::bit_cast<std::uint64_t>(share.of(value)),
                std::bit_cast<std::uint64_t>(to_double((value - origin) / extent)));
    }
  }
  EXPECT_EQ(RoundedShare().of(Rational(1) / 3), 1.0 / 3);
  EXPECT_THROW(RoundedShare(Rational(0), Rational(0)), ContractViolation);
}

}  // namespace
}  // namespace hottel::rounded_share_test
