#include "viewer/edit/decimals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "kernel/support/failure.h"

namespace hottel::decimals_test {
namespace {

Rational power_of_ten(int k) { return *parse_rational("1e" + std::to_string(k)); }

TEST(DecimalsAt, IsTheFinestStepOfFourPixels) {
  EXPECT_EQ(decimals_at(4), 0);
  EXPECT_EQ(decimals_at(std::nextafter(4, 0)), -1);
  EXPECT_EQ(decimals_at(39.99), 0);
  EXPECT_EQ(decimals_at(40), 1);
  EXPECT_EQ(decimals_at(100), 1);
  EXPECT_EQ(decimals_at(1e-3), -4);
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const double pixels =
        std::ldexp(1 + static_cast<double>(random() % 1000) / 1000, static_cast<int>(random() % 600) - 300);
    const int decimals = decimals_at(pixels);
    EXPECT_LE(4 * power_of_ten(decimals), Rational(pixels));
    EXPECT_GT(4 * power_of_ten(decimals + 1), Rational(pixels));
  }
}

TEST(DecimalsAt, RefusesWhatIsNoScale) {
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(decimals_at(wrong), ContractViolation) << wrong;
}

TEST(RoundedDecimal, IsExactlyTheDecimal) {
  EXPECT_EQ(rounded_decimal(0.1, 1), Rational(1, 10));
  EXPECT_EQ(rounded_decimal(-0.1, 3), Rational(-1, 10));
  EXPECT_EQ(rounded_decimal(2.0 / 3, 2), Rational(67, 100));
  EXPECT_EQ(rounded_decimal(1234.0, -2), 1200);
  EXPECT_EQ(rounded_decimal(1e300, 0), Rational(1e300));
}

TEST(RoundedDecimal, IsTheNearestAndTheGreaterOneOfTwo) {
  EXPECT_EQ(rounded_decimal(0.5, 0), 1);
  EXPECT_EQ(rounded_decimal(-0.5, 0), 0);
  EXPECT_EQ(rounded_decimal(Rational(1, 3), 4), Rational(3333, 10000));
  std::mt19937_64 random(2);
  for (int k = 0; k < 1000; ++k) {
    const double value = static_cast<double>(static_cast<std::int64_t>(random())) * 1e-12;
    const int decimals = static_cast<int>(random() % 12) - 3;
    const Rational unit = power_of_ten(-decimals), rounded = rounded_decimal(value, decimals);
    EXPECT_EQ(Rational(rounded / unit).get_den(), 1);
    EXPECT_LE(abs(rounded - Rational(value)) * 2, unit);
  }
}

TEST(Decades, AreTheLeastPowerOfTenThatIsNotBelow) {
  EXPECT_EQ(decades(1), 0);
  EXPECT_EQ(decades(10), 1);
  EXPECT_EQ(decades(Rational(11, 10)), 1);
  EXPECT_EQ(decades(Rational(1, 10)), -1);
  EXPECT_EQ(decades(Rational(101, 1000)), 0);
  for (int k = -400; k <= 400; k += 7) {
    EXPECT_EQ(decades(power_of_ten(k)), k);
    EXPECT_EQ(decades(power_of_ten(k) * 3), k + 1);
  }
  EXPECT_THROW(decades(0), ContractViolation);
}

}  // namespace
}  // namespace hottel::decimals_test
