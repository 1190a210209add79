#include <gtest/gtest.h>

#include <random>

#include "solver/radiosity/scaled_ball.h"

namespace hottel::double_double_ball_test {
namespace {

bool contains(const DoubleDoubleBall& e, const Rational& exact) {
  return abs(exact - Rational(e.hi) - Rational(e.lo)) <= Rational(e.radius);
}

// Rationals of all sizes, many near each other, so that sums cancel.
class Numbers {
 public:
  Rational next() {
    const auto part = [&]() -> Integer {
      return Integer(static_cast<unsigned long>(random_() >> (random_() % 60))) + 1;
    };
    Rational value(part(), part());
    value.canonicalize();
    if (random_() % 4 == 0) value = last_ + value / (Integer(1) << (random_() % 150));
    if (random_() % 2 == 0) value = -value;
    return last_ = value;
  }

 private:
  std::mt19937_64 random_{7};
  Rational last_ = 0;
};

TEST(DoubleDoubleBall, ContainsEveryResultAndIsTight) {
  Numbers numbers;
  for (int k = 0; k < 20'000; ++k) {
    const Rational a = numbers.next(), b = numbers.next();
    const DoubleDoubleBall x = DoubleDoubleBall::of(a), y = DoubleDoubleBall::of(b);
    ASSERT_TRUE(contains(x, a)) << a;
    ASSERT_TRUE(contains(sum(x, y), a + b)) << a << " + " << b;
    ASSERT_TRUE(contains(difference(x, y), a - b)) << a << " - " << b;
    ASSERT_TRUE(contains(product(x, y), a * b)) << a << " * " << b;
    ASSERT_TRUE(contains(sum(product(x, y), negated(product(x, x))), a * b - a * a));
    EXPECT_LE(x.radius, std::abs(x.hi) * 0x1p-104);
    EXPECT_LE(product(x, y).radius, std::abs(x.hi * y.hi) * 0x1p-100);
    const DoubleDoubleBall z = product(x, y);
    EXPECT_LE(Rational(z.lower()), a * b);
    EXPECT_GE(Rational(z.upper()), a * b);
    EXPECT_LE(z.upper() - z.lower(), std::abs(z.hi) * 0x1p-51);
    EXPECT_LE(abs(a), Rational(x.size() * (1 + 0x1p-50)));
  }
}

TEST(DoubleDoubleBall, OfADoubleIsThatDouble) {
  for (const double value : {0.0, 1.0, -0.1, 1e300, 3e-300}) {
    const DoubleDoubleBall e = DoubleDoubleBall::of(Rational(value));
    EXPECT_EQ(e.lower(), value);
    EXPECT_EQ(e.upper(), value);
  }
}

TEST(DoubleDoubleBall, ContainsANumberBeyondTheRangeOfDoubles) {
  const DoubleDoubleBall beyond = DoubleDoubleBall::of(parse_rational("1e400").value());
  EXPECT_EQ(beyond.lower(), -HUGE_VAL);
  EXPECT_EQ(beyond.upper(), HUGE_VAL);
}

bool contains(const ScaledBall& e, const Rational& exact) {
  return contains(e.mantissa, scaled_by_power_of_two(exact, -e.exponent));
}

TEST(ScaledBall, ContainsEveryResultAndIsTightForNumbersOfAnySize) {
  Numbers numbers;
  std::mt19937_64 random(3);
  for (int k = 0; k < 5'000; ++k) {
    const auto shift = [&] { return static_cast<long>(random() % 6001) - 3000; };
    const Rational a = scaled_by_power_of_two(numbers.next(), shift());
    const Rational b = k % 2 == 0 ? numbers.next() * a : scaled_by_power_of_two(numbers.next(), shift());
    const ScaledBall x = ScaledBall::of(a), y = ScaledBall::of(b);
    ASSERT_TRUE(contains(x, a));
    ASSERT_TRUE(contains(y, b));
    ASSERT_TRUE(contains(sum(x, y), a + b));
    ASSERT_TRUE(contains(difference(x, y), a - b));
    const ScaledBall z = product(x, y);
    ASSERT_TRUE(contains(z, a * b));
    EXPECT_LE(z.mantissa.radius, std::abs(z.mantissa.hi) * 0x1p-100);
    EXPECT_TRUE(std::isinf(z.lower()) || Rational(z.lower()) <= a * b);
    EXPECT_TRUE(std::isinf(z.upper()) || Rational(z.upper()) >= a * b);
  }
}

TEST(ScaledBall, LeavesASumAsItIsWhereItIsZero) {
  const ScaledBall one = ScaledBall::of(Rational(1)), zero = ScaledBall::of(Rational(0));
  EXPECT_TRUE(zero.is_zero());
  EXPECT_TRUE(product(one, zero).is_zero());
  EXPECT_EQ(sum(one, zero).lower(), 1);
  EXPECT_EQ(difference(zero, one).upper(), -1);
}

}  // namespace
}  // namespace hottel::double_double_ball_test
