#include "kernel/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace hottel::rational_test {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Rational fraction(const Integer& p, const Integer& q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

Rational power_of_two(long exponent) {
  const Integer power = Integer(1) << static_cast<unsigned long>(std::labs(exponent));
  return exponent >= 0 ? Rational(power) : fraction(1, power);
}

TEST(ParseRational, IsTheValueAsTyped) {
  const auto expect = [](const char* text, long p, long q) {
    const auto value = parse_rational(text);
    ASSERT_TRUE(value) << text;
    EXPECT_EQ(*value, fraction(p, q)) << text;
    EXPECT_EQ(value->get_den(), fraction(p, q).get_den()) << text << " is in lowest terms";
  };
  expect("0", 0, 1);
  expect("-0", 0, 1);
  expect("12", 12, 1);
  expect("+12", 12, 1);
  expect("007", 7, 1);
  expect("0.1", 1, 10);
  expect("-0.10", -1, 10);
  expect(".5", 1, 2);
  expect("5.", 5, 1);
  expect("2.5e-3", 1, 400);
  expect("2.5E+3", 2500, 1);
  expect("1e0", 1, 1);
  expect("4/3", 4, 3);
  expect("-6/4", -3, 2);
  expect("6/-4", -3, 2);
  expect("0/7", 0, 1);
}

TEST(ParseRational, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"",      "+",         "-",     ".",  "e5",  "1e",  "1e+",   " 1",    "1 ",    "1,5",  "--1",   "+-1", "1-2",
        "1.2.3", "1/2/3",     "1/",    "/2", "1/0", "0/0", "1.5/2", "1/2.",  "1e5/2", "0x10", "1_000", "nan", "NaN",
        "inf",   "-Infinity", "1e1.5", "1f", "\t1", "1\n", "½",     "1e--5", "1e5e5", "1/+",  "1 /2",  "e",   ".e1"})
    EXPECT_FALSE(parse_rational(text)) << '"' << text << '"';
  EXPECT_FALSE(parse_rational(std::string_view("1\0", 2)));
}

TEST(ParseRational, HasTheDocumentedLimits) {
  const auto power = [](long exponent) {
    Integer result;
    mpz_ui_pow_ui(result.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
    return result;
  };
  EXPECT_EQ(parse_rational("1e4096"), Rational(power(4096)));
  EXPECT_EQ(parse_rational("-1e-4096"), fraction(-1, power(4096)));
  EXPECT_EQ(parse_rational("0e4096"), Rational(0));
  for (const char* text : {"1e4097", "1e-4097", "0e4097", "1e99999999999999999999", "1e-99999999999999999999"})
    EXPECT_FALSE(parse_rational(text)) << text;

  const std::string nines(kMaxNumberLength, '9');
  EXPECT_EQ(parse_rational(nines), Rational(power(static_cast<long>(kMaxNumberLength)) - 1));
  EXPECT_FALSE(parse_rational(nines + "9"));
  const std::string decimals = "0." + std::string(kMaxNumberLength - 3, '0') + "1";
  EXPECT_EQ(parse_rational(decimals), fraction(1, power(static_cast<long>(kMaxNumberLength) - 2)));
  EXPECT_FALSE(parse_rational("0" + decimals));
  const std::string long_fraction = std::string(2048, '7') + "/" + std::string(2047, '7');
  EXPECT_TRUE(parse_rational(long_fraction));
  EXPECT_FALSE(parse_rational("7" + long_fraction));
}

TEST(ParseRational, ReadsBackWhatIsPrinted) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 1000; ++k) {
    const Integer p = (Integer(random()) << 64) + random() - (Integer(1) << 127), q = Integer(random()) + 1;
    const Rational value = fraction(p, q);
    EXPECT_EQ(parse_rational(to_string(value)), value);
  }
  EXPECT_EQ(to_string(fraction(-6, 4)), "-3/2");
  EXPECT_EQ(to_string(fraction(8, 4)), "2");
}

// Half-way between the largest double and what would follow it: ties to even, which is infinity.
Rational overflow_threshold() { return Rational(kLargest) + power_of_two(970); }

// Is the double nearest, ties to even? Decided in rationals.
bool is_nearest(double rounded, const Rational& value) {
  if (std::isinf(rounded)) return rounded > 0 ? value >= overflow_threshold() : value <= -overflow_threshold();
  const auto half_way = [&](double direction) -> Rational {
    const double neighbour = std::nextafter(rounded, direction);
    if (std::isinf(neighbour)) return neighbour > 0 ? overflow_threshold() : Rational(-overflow_threshold());
    return (Rational(rounded) + Rational(neighbour)) / 2;
  };
  int exponent;
  const double mantissa = std::frexp(rounded, &exponent);
  const int digits = std::min(53, exponent + 1074);
  const bool is_even = rounded == 0 || std::fmod(std::ldexp(mantissa, digits), 2) == 0;
  const Rational low = half_way(-kInfinity), high = half_way(kInfinity);
  return is_even ? low <= value && value <= high : low < value && value < high;
}

TEST(ToDouble, Coverage) {
  EXPECT_EQ(to_double(0), 0.0);
  EXPECT_EQ(to_double(fraction(1, 10)), 0.1);
  EXPECT_EQ(to_double(fraction(-1, 3)), -1.0 / 3.0);
  // Ties go to even, and anything beyond the tie does not.
  const Rational one = 1, half_ulp = power_of_two(-53), nothing = power_of_two(-5000);
  EXPECT_EQ(to_double(one + half_ulp), 1.0);
  EXPECT_EQ(to_double(one + half_ulp + nothing), 1.0 + 0x1p-52);
  EXPECT_EQ(to_double(one + half_ulp - nothing), 1.0);
  EXPECT_EQ(to_double(one + 3 * half_ulp), 1.0 + 0x1p-51);
  EXPECT_EQ(to_double(one + 3 * half_ulp - nothing), 1.0 + 0x1p-52);
  // Overflow begins half an ulp beyond the largest double.
  EXPECT_EQ(to_double(overflow_threshold()), kInfinity);
  EXPECT_EQ(to_double(overflow_threshold() - nothing), kLargest);
  EXPECT_EQ(to_double(-overflow_threshold()), -kInfinity);
  EXPECT_EQ(to_double(nothing - overflow_threshold()), -kLargest);
  EXPECT_EQ(to_double(power_of_two(1024)), kInfinity);
  EXPECT_EQ(to_double(power_of_two(100'000)), kInfinity);
  EXPECT_EQ(to_double(-power_of_two(100'000)), -kInfinity);
  // Subnormals: the step is 2^-1074 all the way down; half of it is a tie with zero.
  const Rational step = power_of_two(-1074);
  EXPECT_EQ(to_double(step), kSmallest);
  EXPECT_EQ(to_double(step / 2), 0.0);
  EXPECT_EQ(to_double(step / 2 + nothing), kSmallest);
  EXPECT_EQ(to_double(step * 3 / 2), 2 * kSmallest);
  EXPECT_EQ(to_double(step * 3 / 2 - nothing), kSmallest);
  EXPECT_EQ(to_double(step * 5 / 2), 2 * kSmallest);
  EXPECT_EQ(to_double(power_of_two(-1022) - step / 2), 0x1p-1022);
  EXPECT_EQ(to_double(power_of_two(-1022) - step), 0x1p-1022 - kSmallest);
  EXPECT_EQ(to_double(power_of_two(-100'000)), 0.0);
  EXPECT_TRUE(std::signbit(to_double(-power_of_two(-100'000))));
}

TEST(ToDouble, Consistency) {
  std::mt19937_64 random(2);
  const long ranges[][2] = {{-60, 60}, {-1080, -1015}, {1015, 1026}, {-1200, 1200}};
  for (const auto& [from, to] : ranges)
    for (int k = 0; k < 2000; ++k) {
      const long exponent = from + static_cast<long>(random() % static_cast<std::uint64_t>(to - from + 1));
      const Integer p = (Integer(random() >> (random() % 60)) << 40) + random() % 1000, q = Integer(random() >> 4) + 1;
      Rational value = fraction(p, q) * power_of_two(exponent);
      if (k % 2 == 1) value = -value;
      EXPECT_TRUE(is_nearest(to_double(value), value)) << value;
    }
}

TEST(ToDouble, IsExactlyRoundedNextToEveryTie) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 4000; ++k) {
    const int exponent = static_cast<int>(random() % 2098) - 1074;
    const double low = std::ldexp(1.0 + static_cast<double>(random() >> 12) * 0x1p-52, exponent);
    const double high = std::nextafter(low, kInfinity);
    if (std::isinf(high)) continue;
    const Rational tie = (Rational(low) + Rational(high)) / 2;
    const Rational little = (tie + 1) * power_of_two(-static_cast<long>(1100 + random() % 4000));
    EXPECT_TRUE(is_nearest(to_double(tie), tie)) << low;
    EXPECT_EQ(to_double(tie - little), low);
    EXPECT_EQ(to_double(tie + little), high);
    EXPECT_EQ(to_double(Rational(low)), low);
  }
}

TEST(Shortest, ReadsBackToTheSameDouble) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(0.0), "0");
  EXPECT_EQ(shortest(1.0), "1");
  EXPECT_EQ(shortest(kSmallest), "5e-324");
  EXPECT_EQ(shortest(-kLargest), "-1.7976931348623157e+308");
  std::mt19937_64 random(4);
  for (int k = 0; k < 2000; ++k) {
    const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 1900) - 1000);
    EXPECT_EQ(std::stod(shortest(value)), value);
  }
}

}  // namespace
}  // namespace hottel::rational_test
