#include "kernel/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hottel::rounding_test {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

Int128 two_to(int exponent) { return static_cast<Int128>(1) << exponent; }

Rational power_of_two(long exponent) {
  const Integer power = Integer(1) << static_cast<unsigned long>(std::labs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(1, power);
}

Rational fraction(const Integer& p, const Integer& q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

RootSum root(const Rational& radicand, const Rational& coefficient = 1) {
  RootSum sum;
  sum.add(coefficient, radicand);
  return sum;
}

Rounded rounded(const Rational& value) {
  const double nearest = to_double(value);
  return {nearest, static_cast<signed char>((value > Rational(nearest)) - (value < Rational(nearest)))};
}

TEST(RoundQuotientOfFixedSums, Coverage) {
  using Result = std::optional<RoundedByTier>;
  const auto expect = [](const Result& result, double value, int side, Tier tier) {
    ASSERT_TRUE(result);
    EXPECT_EQ(result->number, (Rounded{value, static_cast<signed char>(side)}));
    EXPECT_EQ(result->tier, tier);
  };
  const FixedSum zero{0, 0}, one{two_to(120), 0}, third{two_to(120) / 3, 1}, doubtful{two_to(120), 1};
  // Nothing rounded on the way.
  expect(round_quotient(zero, one), 0, 0, Tier::kDouble);
  expect(round_quotient(zero, doubtful), 0, 0, Tier::kDouble);
  expect(round_quotient(FixedSum{1, 0}, FixedSum{3, 0}), 1.0 / 3, 1, Tier::kDouble);
  expect(round_quotient(FixedSum{1, 0}, FixedSum{10, 0}), 0.1, -1, Tier::kDouble);
  expect(round_quotient(one, one), 1, 0, Tier::kDouble);
  // A tie, exactly: 1 + 2^-53.
  expect(round_quotient(FixedSum{two_to(100) + two_to(47), 0}, FixedSum{two_to(100), 0}), 1, 1, Tier::kDouble);
  expect(round_quotient(FixedSum{two_to(100) + 3 * two_to(47), 0}, FixedSum{two_to(100), 0}), 1 + 0x1p-51, -1,
         Tier::kDouble);
  // Enclosed well enough.
  expect(round_quotient(third, one), 1.0 / 3, 1, Tier::kDoubleDouble);
  expect(round_quotient(third, doubtful), 1.0 / 3, 1, Tier::kDoubleDouble);
  expect(round_quotient(FixedSum{-third.value, 1}, one), -1.0 / 3, -1, Tier::kDoubleDouble);
  expect(round_quotient(FixedSum{two_to(120) / 10, 1}, one), 0.1, -1, Tier::kDoubleDouble);
  // A quotient that may be a double, a tie, or anything at all.
  EXPECT_FALSE(round_quotient(doubtful, one));
  EXPECT_FALSE(round_quotient(one, doubtful));
  EXPECT_FALSE(round_quotient(FixedSum{two_to(120) + two_to(67), 1}, one));
  EXPECT_FALSE(round_quotient(FixedSum{5, 100}, one));
  EXPECT_FALSE(round_quotient(FixedSum{0, 100}, one));
}

// Numerators next to ties and to doubles, at every distance: what the fixed-point step settles is true for every pair
// of numbers within the error bounds.
TEST(RoundQuotientOfFixedSums, Consistency) {
  std::mt19937_64 random(1);
  int settled = 0, left_open = 0;
  for (int k = 0; k < 40'000; ++k) {
    const int denominator_bits = 64 + static_cast<int>(random() % 60);
    const Int128 d = two_to(denominator_bits) + (static_cast<Int128>(random() >> 1) << (denominator_bits - 64));
    // A double, or the point half-way to the next one, times d.
    const int exponent = -static_cast<int>(random() % 40);
    const double low = std::ldexp(1 + static_cast<double>(random() >> 12) * 0x1p-52, exponent - 1);
    Rational point = low;
    if (k % 3 != 0) point = (point + Rational(std::nextafter(low, 2))) / 2;
    point *= Rational(to_integer(d));
    const Integer base = point.get_num() / point.get_den();
    const Integer delta = Integer(random()) >> (random() % 64);
    const Integer n = base + (k % 2 == 0 ? delta : Integer(-delta));
    if (n <= 0 || mpz_sizeinbase(n.get_mpz_t(), 2) > 125) continue;
    const Int128 numerator =
        (static_cast<Int128>(Integer(n >> 64).get_ui()) << 64) + Integer(n & 0xffffffffffffffff).get_ui();
    const FixedSum top{numerator, std::ldexp(1.0, static_cast<int>(random() % 20)) - 1};
    const FixedSum bottom{d, k % 5 == 0 ? 0.0 : static_cast<double>(random() % 1000)};
    const auto quick = round_quotient(top, bottom);
    if (!quick) {
      ++left_open;
      continue;
    }
    ++settled;
    const Rational te = top.error, be = bottom.error, t(n), b(to_integer(d));
    ASSERT_EQ(quick->number, rounded((t - te) / (b + be)));
    ASSERT_EQ(quick->number, rounded((t + te) / (b - be)));
    // The exact tier says the same.
    const auto exact = round_quotient(RootSum(t), RootSum(b));
    ASSERT_EQ(quick->number, exact.number);
  }
  EXPECT_GT(settled, 5000);
  EXPECT_GT(left_open, 5000);
}

TEST(RoundScaled, AgreesWithRationals) {
  std::mt19937_64 random(2);
  int settled = 0;
  for (int k = 0; k < 20'000; ++k) {
    Rational unit = fraction(Integer(random()) + 1, (Integer(random()) << (random() % 64)) + 1);
    unit *= power_of_two(static_cast<long>(random() % 1600) - 800);
    if (k % 4 == 0) unit = power_of_two(static_cast<long>(random() % 1600) - 800);
    const FixedSum sum{(static_cast<Int128>(random()) << (random() % 60)) + static_cast<Int128>(random() >> 8),
                       k % 3 == 0 ? 0.0 : static_cast<double>(random() % 100)};
    const auto result = round_scaled(sum, FixedScale(unit));
    if (!result) continue;
    ++settled;
    const Rational value = to_integer(sum.value), error = sum.error;
    ASSERT_EQ(result->number, rounded((value - error) * unit)) << unit << " " << value;
    ASSERT_EQ(result->number, rounded((value + error) * unit)) << unit << " " << value;
  }
  EXPECT_GT(settled, 10'000);
}

TEST(RoundQuotientOfRootSums, Coverage) {
  const auto expect = [](const RoundedByTier& result, double value, int side, Tier tier) {
    EXPECT_EQ(result.number, (Rounded{value, static_cast<signed char>(side)}));
    EXPECT_EQ(result.tier, tier);
  };
  const RootSum one(1);
  expect(round_quotient(RootSum(), one), 0, 0, Tier::kDouble);
  expect(round_quotient(root(2), one), std::sqrt(2.0), -1, Tier::kBall);
  expect(round_quotient(root(2), root(3)), std::sqrt(2.0 / 3), round_quotient(root(6), RootSum(3)).number.side,
         Tier::kBall);
  // The quotient is a double.
  expect(round_quotient(root(8), root(2)), 2, 0, Tier::kRootSum);
  expect(round_quotient(root(2) + root(18), root(32)), 1, 0, Tier::kRootSum);
  // The quotient is a tie: 1 + 2^-53, and its neighbours are none.
  const Rational tie = 1 + power_of_two(-53);
  expect(round_quotient(root(2, tie), root(2)), 1, 1, Tier::kRootSum);
  expect(round_quotient(root(2, tie + power_of_two(-52)), root(2)), 1 + 0x1p-51, -1, Tier::kRootSum);
  expect(round_quotient(root(2, tie + power_of_two(-1000)), root(2)), 1 + 0x1p-52, -1, Tier::kRootSum);
  expect(round_quotient(root(2, tie - power_of_two(-1000)), root(2)), 1, 1, Tier::kRootSum);
  const RootSum speck = root(3, power_of_two(-1000));
  expect(round_quotient(root(2, tie) + speck, root(2)), 1 + 0x1p-52, -1, Tier::kBall);
  expect(round_quotient(root(2, tie) - speck, root(2)), 1, 1, Tier::kBall);
  // Sums of several roots whose quotient is a tie or a double: found equal to it by the canonical form.
  const RootSum several = root(2) + root(3) + RootSum(1);
  expect(round_quotient(several * tie, several), 1, 1, Tier::kRootSum);
  expect(round_quotient(several * Rational(3), several), 3, 0, Tier::kRootSum);
  expect(round_quotient(several * tie + speck, several), 1 + 0x1p-52, -1, Tier::kBall);
  expect(round_quotient(root(2, -tie), root(2)), -1, -1, Tier::kRootSum);
  // Heavy cancellation: the tier is settled by precision alone.
  const Rational big(Integer(1) << 400);
  const RootSum cancelling = root(big * big + 1) - RootSum(big);
  const RoundedByTier small = round_quotient(cancelling, one);
  EXPECT_EQ(small.number.value, 0x1p-401);
  EXPECT_EQ(small.number.side, -1);
}

TEST(RoundQuotientOfRootSums, MeetsTheEndsOfTheRangeOfDouble) {
  const RootSum one(1);
  const auto round = [&](const Rational& factor) { return round_quotient(root(2, factor), root(2)).number; };
  EXPECT_EQ(round(power_of_two(2000)), (Rounded{HUGE_VAL, -1}));
  EXPECT_EQ(round(-power_of_two(2000)), (Rounded{-HUGE_VAL, 1}));
  EXPECT_EQ(round(power_of_two(-2000)), (Rounded{0, 1}));
  EXPECT_EQ(round(Rational(kLargest)), (Rounded{kLargest, 0}));
  const Rational threshold = Rational(kLargest) + power_of_two(970);
  EXPECT_EQ(round(threshold), (Rounded{HUGE_VAL, -1}));
  EXPECT_EQ(round(threshold - power_of_two(-100)), (Rounded{kLargest, 1}));
  EXPECT_EQ(round(threshold + power_of_two(-100)), (Rounded{HUGE_VAL, -1}));
  EXPECT_EQ(round(power_of_two(-1074)), (Rounded{kSmallest, 0}));
  EXPECT_EQ(round(power_of_two(-1075)), (Rounded{0, 1}));
  EXPECT_EQ(round(power_of_two(-1075) + power_of_two(-3000)), (Rounded{kSmallest, -1}));
  EXPECT_EQ(round(3 * power_of_two(-1075)), (Rounded{2 * kSmallest, -1}));
}

TEST(FixedDividend, MayBeZeroUnlessItIsGreaterThanItsError) {
  EXPECT_TRUE(FixedDividend({0, 0}).may_be_zero());
  EXPECT_TRUE(FixedDividend({5, 5}).may_be_zero());
  EXPECT_TRUE(FixedDividend({-5, 0}).may_be_zero());
  EXPECT_FALSE(FixedDividend({5, 4}).may_be_zero());
  EXPECT_FALSE(FixedDividend({1, 0}).may_be_zero());
}

TEST(FixedDivisor, IsUsableWhereItIsGreaterThanItsError) {
  EXPECT_FALSE(FixedDivisor().is_usable());
  EXPECT_FALSE(FixedDivisor({0, 0}).is_usable());
  EXPECT_FALSE(FixedDivisor({5, 5}).is_usable());
  EXPECT_FALSE(FixedDivisor({-5, 0}).is_usable());
  EXPECT_TRUE(FixedDivisor({5, 4}).is_usable());
  EXPECT_TRUE(FixedDivisor({1, 0}).is_usable());
}

TEST(RoundQuotientOfRootSums, Consistency) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 2000; ++k) {
    // A quotient of rationals in disguise, at a chosen distance from a tie or a double.
    const double low = std::ldexp(1 + static_cast<double>(random() >> 12) * 0x1p-52, -static_cast<int>(random() % 60));
    Rational value = low;
    if (k % 2 == 0) value = (value + Rational(std::nextafter(low, 2))) / 2;
    if (k % 3 != 0) value += (k % 3 == 1 ? 1 : -1) * power_of_two(-static_cast<long>(60 + random() % 600));
    const Integer radicand = Integer(random() % 1000) + 2;
    const RootSum denominator = root(radicand, fraction(static_cast<long>(random() % 50) + 1, 7)) + RootSum(3);
    EXPECT_EQ(round_quotient(denominator * value, denominator).number, rounded(value));
  }
}

TEST(RoundedNumber, IsEnclosedWithinOneUlp) {
  EXPECT_EQ((Rounded{1, 0}).enclosure(), (Enclosure{1, 1}));
  EXPECT_EQ((Rounded{1, 1}).enclosure(), (Enclosure{1, 1 + 0x1p-52}));
  EXPECT_EQ((Rounded{1, -1}).enclosure(), (Enclosure{1 - 0x1p-53, 1}));
  EXPECT_EQ((Rounded{0, 1}).enclosure(), (Enclosure{0, kSmallest}));
  EXPECT_EQ((Rounded{HUGE_VAL, -1}).enclosure(), (Enclosure{kLargest, HUGE_VAL}));
}

}  // namespace
}  // namespace hottel::rounding_test
