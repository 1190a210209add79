#include "kernel/ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "kernel/root_sum.h"

namespace hottel::ball_test {
namespace {

Rational fraction(long p, long q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

TEST(Ball, ContainsTheResultOfEveryOperation) {
  std::mt19937_64 random(1);
  const auto any = [&] {
    return fraction(static_cast<long>(random() % 2000) - 1000, static_cast<long>(random() % 1000) + 1);
  };
  for (int k = 0; k < 300; ++k)
    for (const long precision : {4L, 20L, 64L, 300L}) {
      const Rational a = any(), b = any();
      const Ball x = Ball::of(a, precision), y = Ball::of(b, precision);
      const auto expect = [](const Ball& ball, const Rational& value) {
        const Enclosure bounds = ball.bounds();
        EXPECT_LE(Rational(bounds.lower), value);
        EXPECT_GE(Rational(bounds.upper), value);
        const int sign = ball.sign();
        EXPECT_TRUE(sign == 0 || sign == sgn(value));
      };
      expect(x, a);
      expect(x.plus(y, precision), a + b);
      expect(x.minus(y, precision), a - b);
      expect(x.times(y, precision), a * b);
      if (y.sign() != 0) expect(x.over(y, precision), a / b);
    }
}

TEST(Ball, HasBoundsAtMostTwoUlpsWideAtHighPrecision) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 300; ++k) {
    RootSum sum;
    for (int t = 0; t < 4; ++t) sum.add(static_cast<long>(random() % 9) - 4, static_cast<long>(random() % 30));
    const Enclosure bounds = sum.ball(300).bounds();
    EXPECT_LE(bounds.lower, bounds.upper);
    EXPECT_LE(bounds.upper, std::nextafter(std::nextafter(bounds.lower, HUGE_VAL), HUGE_VAL));
  }
}

TEST(Ball, ComparesWithDoubles) {
  RootSum root;
  root.add(1, 2);
  const Ball ball = root.ball(200);
  const double nearest = std::numbers::sqrt2;
  EXPECT_EQ(ball.compare(nearest), -1);  // sqrt(2) lies below the double nearest to it
  EXPECT_EQ(ball.compare(std::nextafter(nearest, 0)), 1);
  EXPECT_EQ(root.ball(20).compare(nearest), 0) << "not settled at 20 bits";
  EXPECT_EQ(ball.nearest_of_ends(), (Enclosure{nearest, nearest}));
  EXPECT_EQ(Ball::of(Rational(3), 64).compare(3.0), 0);
  EXPECT_EQ(Ball::of(Rational(3), 64).sign(), 1);
  EXPECT_EQ(Ball::of(Rational(0), 64).sign(), 0);
  EXPECT_EQ(Ball().sign(), 0);
}

TEST(Ball, KnowsAnglesInAllQuadrants) {
  constexpr long kPrecision = 200;
  const auto angle = [](long y, long x) {
    return Ball::atan2(Ball::of(Rational(y), kPrecision), Ball::of(Rational(x), kPrecision), kPrecision);
  };
  const double pi = std::numbers::pi;
  EXPECT_EQ(Ball::pi(kPrecision).nearest_of_ends(), (Enclosure{pi, pi}));
  EXPECT_EQ(angle(0, 5).nearest_of_ends(), (Enclosure{0, 0}));
  EXPECT_EQ(angle(3, 3).nearest_of_ends(), (Enclosure{pi / 4, pi / 4}));
  EXPECT_EQ(angle(2, 0).nearest_of_ends(), (Enclosure{pi / 2, pi / 2}));
  EXPECT_EQ(angle(0, -1).nearest_of_ends(), (Enclosure{pi, pi}));
  EXPECT_EQ(angle(-2, 0).nearest_of_ends(), (Enclosure{-pi / 2, -pi / 2}));
  EXPECT_EQ(angle(-7, -7).nearest_of_ends(), (Enclosure{-3 * pi / 4, -3 * pi / 4}));
}

TEST(Ball, IsCopiedByValue) {
  Ball a = Ball::of(Rational(1), 64);
  const Ball b = a;
  a = Ball::of(Rational(2), 64);
  EXPECT_EQ(b.bounds(), (Enclosure{1, 1}));
  EXPECT_EQ(a.bounds(), (Enclosure{2, 2}));
  const Ball c = std::move(a);
  EXPECT_EQ(c.bounds(), (Enclosure{2, 2}));
}

TEST(Ball, HoldsNumbersBeyondTheRangeOfDouble) {
  RootSum huge, tiny;
  huge.add(1, Rational(Integer(1) << 100'001));
  Rational small(1, Integer(1) << 100'001);
  tiny.add(1, small);
  EXPECT_EQ(huge.ball(64).nearest_of_ends(), (Enclosure{HUGE_VAL, HUGE_VAL}));
  EXPECT_EQ(tiny.ball(64).nearest_of_ends(), (Enclosure{0, 0}));
  EXPECT_EQ(tiny.ball(64).sign(), 1);
  EXPECT_EQ(tiny.ball(64).compare(0.0), 1);
  EXPECT_EQ(huge.ball(64).compare(std::numeric_limits<double>::max()), 1);
}

}  // namespace
}  // namespace hottel::ball_test
