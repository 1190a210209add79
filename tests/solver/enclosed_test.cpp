#include "solver/system/enclosed.h"

#include <gtest/gtest.h>

#include <random>

namespace hottel {
namespace {

bool contains(const Enclosed& e, const Rational& exact) {
  return abs(exact - Rational(e.hi) - Rational(e.lo)) <= Rational(e.radius);
}

// Rationals of all sizes, many near each other, so that sums cancel.
class Numbers {
 public:
  Rational next() {
    const auto part = [&] { return Integer(static_cast<unsigned long>(random_() >> (random_() % 60))) + 1; };
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

TEST(Enclosed, ContainsEveryResultAndIsTight) {
  Numbers numbers;
  for (int k = 0; k < 20'000; ++k) {
    const Rational a = numbers.next(), b = numbers.next();
    const Enclosed x = Enclosed::of(a), y = Enclosed::of(b);
    ASSERT_TRUE(contains(x, a)) << a;
    ASSERT_TRUE(contains(sum(x, y), a + b)) << a << " + " << b;
    ASSERT_TRUE(contains(difference(x, y), a - b)) << a << " - " << b;
    ASSERT_TRUE(contains(product(x, y), a * b)) << a << " * " << b;
    ASSERT_TRUE(contains(sum(product(x, y), negated(product(x, x))), a * b - a * a));
    EXPECT_LE(x.radius, std::abs(x.hi) * 0x1p-104);
    EXPECT_LE(product(x, y).radius, std::abs(x.hi * y.hi) * 0x1p-100);
    const Enclosed z = product(x, y);
    EXPECT_LE(Rational(z.lower()), a * b);
    EXPECT_GE(Rational(z.upper()), a * b);
    EXPECT_LE(z.upper() - z.lower(), std::abs(z.hi) * 0x1p-51);
    EXPECT_LE(abs(a), Rational(x.size() * (1 + 0x1p-50)));
  }
}

TEST(Enclosed, OfADoubleIsThatDouble) {
  for (const double value : {0.0, 1.0, -0.1, 1e300, 3e-300}) {
    const Enclosed e = Enclosed::of(Rational(value));
    EXPECT_EQ(e.lower(), value);
    EXPECT_EQ(e.upper(), value);
  }
}

TEST(Enclosed, ContainsANumberBeyondTheRangeOfDoubles) {
  const Enclosed beyond = Enclosed::of(parse_rational("1e400").value());
  EXPECT_EQ(beyond.lower(), -HUGE_VAL);
  EXPECT_EQ(beyond.upper(), HUGE_VAL);
}

}  // namespace
}  // namespace hottel
