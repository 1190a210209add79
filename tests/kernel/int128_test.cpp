// Conversions of 128-bit integers against big numbers.
#include "kernel/int128.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/rational.h"

namespace hottel::int128_test {
namespace {

// Numbers of every size, of both signs, and those about a power of two.
template <class Check>
void for_each_number(const Check& check) {
  std::mt19937_64 random(1);
  for (int bits = 0; bits < 126; ++bits)
    for (int k = 0; k < 40; ++k) {
      const Int128 power = static_cast<Int128>(1) << bits;
      const Int128 below = ((static_cast<Int128>(random() >> 1) << 63) + static_cast<Int128>(random() >> 1)) % power;
      const Int128 magnitude = k < 5 ? power - 2 + k : power + below;
      for (const Int128 value : {magnitude, -magnitude})
        if (magnitude >= 0 && magnitude < static_cast<Int128>(1) << 125) check(value);
    }
}

Rational power_of_two(int exponent) { return scaled_by_power_of_two(Rational(1), exponent); }

TEST(DoubleNear, IsOffByAtMostItsBoundAndExactUpTo53Bits) {
  for_each_number([](Int128 value) {
    const Rational exact(to_integer(value)), error = abs(Rational(double_near(value)) - exact);
    EXPECT_LE(error, abs(exact) * power_of_two(-51)) << exact;
    if (abs(exact) <= power_of_two(53)) {
      EXPECT_EQ(error, 0) << exact;
    }
  });
}

TEST(ToDoubleDouble, IsExactUpTo106BitsAndNearBeyond) {
  for_each_number([](Int128 value) {
    const Rational exact(to_integer(value));
    const DoubleDouble near = to_double_double(value);
    const Rational error = abs(Rational(near.hi) + Rational(near.lo) - exact);
    EXPECT_LE(error, abs(exact) * power_of_two(-103)) << exact;
    if (abs(exact) < power_of_two(106)) {
      EXPECT_EQ(error, 0) << exact;
    }
    EXPECT_LE(std::fabs(near.lo), std::ldexp(std::fabs(near.hi), -53)) << exact;
  });
}

}  // namespace
}  // namespace hottel::int128_test
