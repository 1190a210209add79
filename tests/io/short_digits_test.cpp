// Numbers with few digits: what short_digits.h says of them.
#include "io/results/short_digits.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>

#include "kernel/support/failure.h"

namespace hottel::short_digits_test {
namespace {

double read(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

// Any finite double, of either sign, subnormal ones too.
double some_double(std::mt19937_64& random) {
  for (;;)
    if (const auto value = std::bit_cast<double>(random()); std::isfinite(value)) return value;
}

std::size_t significant_digits(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e')))
    if (c >= '0' && c <= '9') digits += c;
  const std::size_t first = digits.find_first_not_of('0'), last = digits.find_last_not_of('0');
  return first == std::string::npos ? 0 : last - first + 1;
}

TEST(ShortDigits, AreWhatTheyWereWhereTheySuffice) {
  EXPECT_EQ(short_digits(0.1, std::nullopt), "0.1");
  for (const RoundedTo to : {RoundedTo::kNearest, RoundedTo::kBelow, RoundedTo::kAbove}) {
    EXPECT_EQ(short_digits(0.1, 1, to), "0.1");
    EXPECT_EQ(short_digits(0, 3, to), "0");
    EXPECT_EQ(short_digits(1, 1, to), "1");
    EXPECT_EQ(short_digits(-250, 2, to), "-250");
    EXPECT_EQ(short_digits(0x1p63, 17, to), "9.223372036854776e+18");
    EXPECT_EQ(short_digits(std::numeric_limits<double>::infinity(), 2, to), "inf");
  }
}

TEST(ShortDigits, AreRoundedToTheNearestOrOutward) {
  EXPECT_EQ(short_digits(0.11803398874989485, 3), "0.118");
  EXPECT_EQ(short_digits(0.11803398874989485, 3, RoundedTo::kBelow), "0.118");
  EXPECT_EQ(short_digits(0.11803398874989485, 3, RoundedTo::kAbove), "0.119");
  EXPECT_EQ(short_digits(-0.11803398874989485, 3, RoundedTo::kBelow), "-0.119");
  EXPECT_EQ(short_digits(-0.11803398874989485, 3, RoundedTo::kAbove), "-0.118");
  EXPECT_EQ(short_digits(0.9996, 3), "1");
  EXPECT_EQ(short_digits(0.9996, 3, RoundedTo::kBelow), "0.999");
  EXPECT_EQ(short_digits(9.9901e-30, 3, RoundedTo::kAbove), "1e-29");
  EXPECT_EQ(short_digits(1.5e308 + 1.23e307, 1, RoundedTo::kAbove), "inf");  // 2e308
  EXPECT_EQ(short_digits(1.7e308, 1), "1e+308") << "the nearest is beyond doubles";
  EXPECT_EQ(short_digits(-1.7e308, 1), "-1e+308");
}

// Of a tie in decimals the double decides, which is seldom one: 2.675 is a little less.
TEST(ShortDigits, TheNearestIsThatOfTheDouble) {
  EXPECT_EQ(short_digits(2.675, 3), "2.67");
  EXPECT_EQ(short_digits(0.5, 1), "0.5");
  EXPECT_EQ(short_digits(2.5, 1), "2");
  EXPECT_EQ(short_digits(3.5, 1), "4");
}

TEST(ShortDigits, BoundsStayBoundsWhateverTheDouble) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 100'000; ++k) {
    const double value = some_double(random);
    const int digits = 1 + static_cast<int>(random() % kMostDigits);
    const std::string below = short_digits(value, digits, RoundedTo::kBelow),
                      above = short_digits(value, digits, RoundedTo::kAbove), near = short_digits(value, digits);
    ASSERT_LE(read(below), value) << below << " " << digits;
    ASSERT_GE(read(above), value) << above << " " << digits;
    ASSERT_LE(read(below), read(near)) << near;
    ASSERT_LE(read(near), read(above)) << near;
    for (const std::string& text : {below, above, near})
      ASSERT_LE(significant_digits(text), static_cast<std::size_t>(digits)) << text;
  }
}

TEST(ShortDigits, SeventeenTellAnyDouble) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 1000; ++k) {
    const double value = some_double(random);
    EXPECT_EQ(read(short_digits(value, kMostDigits, RoundedTo::kAbove)), value);
  }
}

TEST(ShortDigits, AVisibilityBelowOneIsNotOne) {
  EXPECT_EQ(short_visibility(1, 2), "1");
  EXPECT_EQ(short_visibility(std::nextafter(1.0, 0.0), 2), "0.99");
  EXPECT_EQ(short_visibility(0.5, std::nullopt), "0.5");
}

TEST(ShortDigits, NoDigitsAndTooManyAreRefused) {
  for (const int digits : {0, -1, kMostDigits + 1}) EXPECT_THROW(short_digits(0.25, digits), ContractViolation);
}

}  // namespace
}  // namespace hottel::short_digits_test
