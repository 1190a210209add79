// Decimals for people, inside the range of doubles and beyond.
#include "kernel/decimal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hottel::decimal_test {
namespace {

Rational number(const std::string& text) { return parse_rational(text).value(); }

TEST(DecimalText, IsTheShortestOfTheNearestDouble) {
  for (const char* text : {"0", "1", "-0.1", "1/3", "1e308", "2e-308", "5e-324", "123456789012345678"})
    EXPECT_EQ(decimal_text(number(text)), shortest(to_double(number(text)))) << text;
}

TEST(DecimalText, GoesOnBeyondTheRangeOfDoubles) {
  EXPECT_EQ(decimal_text(number("1e400")), "1e+400");
  EXPECT_EQ(decimal_text(number("-12e800")), "-1.2e+801");
  EXPECT_EQ(decimal_text(number("3e-400")), "3e-400");
  EXPECT_EQ(decimal_text(number("-7.25e-4000")), "-7.25e-4000");
  EXPECT_EQ(decimal_text(number("1e4000") / 3), "3.3333333333333335e+3999");
  // From the last double on: half-way to the next power of two everything is infinite.
  EXPECT_EQ(decimal_text(number("1.8e308")), "1.8e+308");
  EXPECT_EQ(decimal_text(number("2e-324")), "2e-324");
}

TEST(DecimalText, OfARootIsThatOfItsValue) {
  RootSum root;
  root.add(number("1e500"), 2);
  EXPECT_EQ(decimal_text(root), "1.4142135623730951e+500");
  root *= number("1e-500");
  EXPECT_EQ(decimal_text(root), shortest(std::sqrt(2.0)));
  root *= number("-1e-1000");
  EXPECT_EQ(decimal_text(root), "-1.4142135623730951e-1000");
}

TEST(DecimalText, ReadsBackToTheNumberWithinItsLastPlace) {
  for (int k = -900; k <= 900; k += 37) {
    const Rational value = number("1.23456789012345678901234567890e" + std::to_string(k));
    const Rational read = number(decimal_text(value));
    const Rational error = abs(read - value) / value;
    EXPECT_LT(to_double(error), 0x1p-52) << k;
  }
}

}  // namespace
}  // namespace hottel::decimal_test
