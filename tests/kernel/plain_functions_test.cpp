// Every function against MPFR. HOTTEL_POINTS=1000000 takes as many points of
// each kind, and some minutes.
#include "kernel/plain_functions.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

namespace hottel::plain_functions_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int points() {
  const char* const told = std::getenv("HOTTEL_POINTS");
  return told != nullptr ? std::atoi(told) : 20'000;
}

class Number {
 public:
  explicit Number(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  ~Number() { mpfr_clear(value_); }
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

// How far a double is off, in units of the last place of the true value.
double units_off(Number& truth, double value) {
  const double nearest = mpfr_get_d(truth.get(), MPFR_RNDN);
  if (std::isnan(nearest) || std::isnan(value)) return std::isnan(nearest) && std::isnan(value) ? 0 : kInfinity;
  if (nearest == value && (std::isinf(value) || value == 0)) return 0;
  const long unit = std::max<long>(mpfr_get_exp(truth.get()) - 53, -1074);
  Number off(160);
  mpfr_sub_d(off.get(), truth.get(), value, MPFR_RNDN);
  mpfr_mul_2si(off.get(), off.get(), -unit, MPFR_RNDN);
  return std::fabs(mpfr_get_d(off.get(), MPFR_RNDN));
}

class Random {
 public:
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(generator_); }
  double any() { return std::bit_cast<double>(generator_()); }
  // With an exponent between two.
  double sized(int low, int high) {
    return std::ldexp(between(1, 2), std::uniform_int_distribution(low, high)(generator_));
  }
  double signed_sized(int low, int high) { return generator_() % 2 == 0 ? sized(low, high) : -sized(low, high); }

 private:
  std::mt19937_64 generator_{5};
};

using Function = double (*)(double);
using Truth = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Draw = std::function<double(Random&)>;

// At many points the function is off by no more units
// than that.
void expect_within(double most, Function function, Truth truth, const Draw& draw) {
  Random random;
  Number x(53), value(160);
  double worst = 0, at = 0;
  for (int k = 0; k < points(); ++k) {
    const double argument = draw(random);
    mpfr_set_d(x.get(), argument, MPFR_RNDN);
    truth(value.get(), x.get(), MPFR_RNDN);
    if (const double off = units_off(value, function(argument)); off > worst)
      std::tie(worst, at) = std::pair(off, argument);
  }
  EXPECT_LE(worst, most) << std::hexfloat << at;
}

using Function2 = double (*)(double, double);
using Truth2 = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
using Draw2 = std::function<std::pair<double, double>(Random&)>;

void expect_within(double most, Function2 function, Truth2 truth, const Draw2& draw) {
  Random random;
  Number x(53), y(53), value(160);
  double worst = 0;
  std::pair<double, double> at;
  for (int k = 0; k < points(); ++k) {
    const auto arguments = draw(random);
    mpfr_set_d(x.get(), arguments.first, MPFR_RNDN);
    mpfr_set_d(y.get(), arguments.second, MPFR_RNDN);
    truth(value.get(), x.get(), y.get(), MPFR_RNDN);
    if (const double off = units_off(value, function(arguments.first, arguments.second)); off > worst)
      std::tie(worst, at) = std::pair(off, arguments);
  }
  EXPECT_LE(worst, most) << std::hexfloat << at.first << " and " << at.second;
}

double any(Random& random) { return random.any(); }
double near_one(Random& random) { return 1 + random.signed_sized(-53, -2); }
double small(Random& random) { return random.signed_sized(-1074, -3); }
double middling(Random& random) { return random.signed_sized(-60, 6); }
// The double nearest to a multiple of a quarter turn.
double quarter(Random& random) {
  return static_cast<double>(std::floor(random.between(-660'000, 660'000)) * (std::numbers::pi_v<long double> / 2));
}

TEST(PlainLogarithm, IsWithinItsBound) {
  for (const Draw& draw : {Draw(any), Draw(near_one)}) expect_within(0.51, same_bits::log, mpfr_log, draw);
  expect_within(0.51, same_bits::log, mpfr_log, [](Random& random) { return random.between(0.25, 4); });
  expect_within(0.51, same_bits::log, mpfr_log, [](Random& random) { return random.sized(-1074, -1000); });
}

TEST(PlainLogarithm, OfOtherBasesIsWithinItsBoundAndExactOfPowers) {
  for (const Draw& draw : {Draw(any), Draw(near_one)}) {
    expect_within(0.51, same_bits::log2, mpfr_log2, draw);
    expect_within(0.51, same_bits::log10, mpfr_log10, draw);
  }
  for (int k = -1074; k < 1024; ++k) ASSERT_EQ(same_bits::log2(std::ldexp(1.0, k)), k);
  double power = 1;
  for (int k = 0; k <= 22; ++k, power *= 10) ASSERT_EQ(same_bits::log10(power), k);
}

TEST(PlainLogarithm, OfOneMoreIsWithinItsBound) {
  for (const Draw& draw : {Draw(small), Draw(middling)}) expect_within(0.7, same_bits::log1p, mpfr_log1p, draw);
  expect_within(0.7, same_bits::log1p, mpfr_log1p, [](Random& random) { return random.sized(-53, 1023); });
  expect_within(0.7, same_bits::log1p, mpfr_log1p, [](Random& random) { return random.sized(-53, -1) - 1; });
}

TEST(PlainExponential, IsWithinItsBound) {
  for (const Draw& draw : {Draw(small), Draw(middling)}) expect_within(0.52, same_bits::exp, mpfr_exp, draw);
  expect_within(0.52, same_bits::exp, mpfr_exp, [](Random& random) { return random.between(-708, 710); });
  for (const Draw& draw : {Draw(any), Draw([](Random& random) { return random.between(-746, -708); })})
    expect_within(0.76, same_bits::exp, mpfr_exp, draw);
}

TEST(PlainExponential, LessOneIsWithinItsBound) {
  for (const Draw& draw : {Draw(any), Draw(small), Draw(middling)})
    expect_within(0.62, same_bits::expm1, mpfr_expm1, draw);
  expect_within(0.62, same_bits::expm1, mpfr_expm1, [](Random& random) { return random.between(-60, 710); });
  expect_within(0.62, same_bits::expm1, mpfr_expm1, [](Random& random) { return random.between(-0.1, 0.1); });
}

TEST(PlainPower, IsWithinItsBound) {
  const auto of_result = [](double x, Random& random, double low) {
    return std::pair(x, random.between(low, 710) / std::log(x));
  };
  expect_within(0.57, same_bits::pow, mpfr_pow,
                [&](Random& random) { return of_result(random.sized(-1074, 1023), random, -708); });
  expect_within(0.57, same_bits::pow, mpfr_pow,
                [&](Random& random) { return of_result(near_one(random), random, -700); });
  expect_within(0.57, same_bits::pow, mpfr_pow,
                [](Random& random) { return std::pair(random.between(0, 1), random.between(0, 40)); });
  expect_within(0.8, same_bits::pow, mpfr_pow,
                [&](Random& random) { return of_result(random.sized(-1074, 1023), random, -750); });
  expect_within(0.8, same_bits::pow, mpfr_pow,
                [](Random& random) { return std::pair(std::fabs(random.any()), random.any()); });
}

TEST(PlainPower, OfTenIsExactWhereADoubleIs) {
  double power = 1;
  for (int k = 0; k <= 22; ++k, power *= 10) ASSERT_EQ(same_bits::pow(10, k), power);
}

TEST(PlainAngle, IsWithinItsBound) {
  const auto both = [](const Draw& draw) {
    return [draw](Random& random) {
      const double y = draw(random);
      return std::pair(y, draw(random));
    };
  };
  expect_within(0.51, same_bits::atan2, mpfr_atan2, both(any));
  expect_within(0.51, same_bits::atan2, mpfr_atan2, both([](Random& random) { return random.between(-1, 1); }));
  expect_within(0.51, same_bits::atan2, mpfr_atan2,
                both([](Random& random) { return random.signed_sized(-1074, -900); }));
  expect_within(0.51, same_bits::atan2, mpfr_atan2,
                both([](Random& random) { return random.signed_sized(900, 1023); }));
  expect_within(0.51, same_bits::atan2, mpfr_atan2, both([](Random& random) { return random.signed_sized(-40, 40); }));
  expect_within(0.51, same_bits::atan2, mpfr_atan2,
                both([](Random& random) { return std::floor(random.between(-99, 99)); }));
  expect_within(0.51, same_bits::atan, mpfr_atan, any);
}

TEST(PlainAngle, OfACosineIsWithinItsBound) {
  expect_within(1.6, same_bits::acos, mpfr_acos, [](Random& random) { return random.between(-1.1, 1.1); });
  expect_within(1.6, same_bits::acos, mpfr_acos, [](Random& random) { return 1 - random.sized(-53, 0); });
  expect_within(1.6, same_bits::acos, mpfr_acos, small);
}

TEST(PlainSine, IsWithinItsBound) {
  for (const Draw& draw : {Draw(small), Draw(quarter), Draw([](Random& random) { return random.between(-8, 8); }),
                           Draw([](Random& random) { return random.signed_sized(-60, 19); })}) {
    expect_within(0.62, same_bits::sin, mpfr_sin, draw);
    expect_within(0.62, same_bits::cos, mpfr_cos, draw);
    expect_within(2, same_bits::tan, mpfr_tan, draw);
  }
}

TEST(PlainSine, OfHugeAnglesIsTheNearest) {
  Random random;
  Number x(53), value(160);
  for (int k = 0; k < points() / 20; ++k) {
    const double angle = random.signed_sized(20, 1023);
    mpfr_set_d(x.get(), angle, MPFR_RNDN);
    mpfr_sin(value.get(), x.get(), MPFR_RNDN);
    ASSERT_EQ(same_bits::sin(angle), mpfr_get_d(value.get(), MPFR_RNDN));
    mpfr_cos(value.get(), x.get(), MPFR_RNDN);
    ASSERT_EQ(same_bits::cos(angle), mpfr_get_d(value.get(), MPFR_RNDN));
  }
}

constexpr double kSpecial[] = {0,
                               -0.0,
                               1,
                               -1,
                               2,
                               -2,
                               0.5,
                               kInfinity,
                               -kInfinity,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::denorm_min(),
                               std::numeric_limits<double>::min(),
                               std::numeric_limits<double>::max(),
                               -std::numeric_limits<double>::max()};

bool is_same(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(PlainFunctions, HaveTheSpecialValuesOfTheStandard) {
  const auto expect_same = [](Function function, Truth truth, const char* name) {
    Number x(53), value(53);
    for (const double special : kSpecial) {
      mpfr_set_d(x.get(), special, MPFR_RNDN);
      truth(value.get(), x.get(), MPFR_RNDN);
      const double nearest = mpfr_get_d(value.get(), MPFR_RNDN), own = function(special);
      if (std::isnan(nearest) || std::isinf(nearest) || nearest == 0) {
        EXPECT_TRUE(is_same(own, nearest)) << name << " of " << special << ": " << own;
      }
    }
  };
  expect_same(same_bits::log, mpfr_log, "log");
  expect_same(same_bits::log2, mpfr_log2, "log2");
  expect_same(same_bits::log10, mpfr_log10, "log10");
  expect_same(same_bits::log1p, mpfr_log1p, "log1p");
  expect_same(same_bits::exp, mpfr_exp, "exp");
  expect_same(same_bits::expm1, mpfr_expm1, "expm1");
  expect_same(same_bits::sin, mpfr_sin, "sin");
  expect_same(same_bits::cos, mpfr_cos, "cos");
  expect_same(same_bits::tan, mpfr_tan, "tan");
  expect_same(same_bits::acos, mpfr_acos, "acos");
  expect_same(same_bits::atan, mpfr_atan, "atan");
  for (const double y : kSpecial)
    for (const double x : kSpecial) {
      EXPECT_TRUE(is_same(same_bits::atan2(y, x), std::atan2(y, x))) << y << ", " << x;
      const double power = std::pow(x, y);
      if (x >= 0 && !std::signbit(x) && (!std::isfinite(power) || power == 0 || power == 1)) {
        EXPECT_TRUE(is_same(same_bits::pow(x, y), power)) << x << " to the " << y;
      }
    }
}

// Numbers as some processor had them once.
TEST(PlainFunctions, HaveTheSameBitsOnEveryProcessor) {
  std::uint64_t all = 0;
  const auto mix = [&](double value) { all = (all ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u; };
  for (int k = 1; k <= 100'000; ++k) {
    const double x = k / 1024.0 / 17;
    for (const Function function :
         {&same_bits::log10, &same_bits::log2, &same_bits::log1p, &same_bits::expm1, &same_bits::tan})
      mix(function(x));
    mix(same_bits::log(x));
    mix(same_bits::exp(-x));
    mix(same_bits::pow(x, 2.2));
    mix(same_bits::atan2(1 - x, 2));
    mix(same_bits::acos(1 - x / 4));
    mix(same_bits::sin(x));
    mix(same_bits::cos(9 * x));
  }
  EXPECT_EQ(all, 18307550770412662141u);
}

}  // namespace
}  // namespace hottel::plain_functions_test
