// Doubles as exact numbers and back: what there is an answer for, and what is refused instead of a signal.
#include "kernel/exact_double.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel::exact_double_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

Rational number(const std::string& text) { return *parse_rational(text); }

TEST(ExactDouble, EveryFiniteDoubleIsItsValue) {
  for (const double value : {0.0, -0.0, 0.1, -3.5, kLargest, -kLargest, kLeast, std::ldexp(1.0, -1022)}) {
    EXPECT_EQ(to_double(exact_value(value)), value);
    EXPECT_EQ(finite(value), value);
  }
  EXPECT_EQ(exact_value(0.1), Rational(Integer(3602879701896397), Integer(1) << 55));
  EXPECT_EQ(exact_integer(-2.75), -2);
  EXPECT_EQ(exact_integer(0x1p300), Integer(1) << 300);
}

TEST(ExactDouble, WhatIsNoNumberIsRefused) {
  for (const double value : {kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_THROW(exact_value(value), RequestError);
    EXPECT_THROW(exact_integer(value), RequestError);
    EXPECT_THROW(finite(value), RequestError);
  }
}

TEST(ExactDouble, NumbersOfAnySizeAreCutOff) {
  for (const char* text : {"1e308", "-1e308", "1e-330", "1e400", "-1e400", "1e4000", "1e-4000", "1/3", "-7", "0"}) {
    const Rational value = number(text);
    const double cut = truncated_double(value), nearest = to_double(value);
    EXPECT_LE(std::fabs(cut), std::fabs(nearest)) << text;
    EXPECT_GE(std::fabs(cut), std::nextafter(std::fabs(nearest), 0.0)) << text;
    EXPECT_EQ(std::signbit(cut) && cut != 0, nearest < 0) << text;
    const Integer whole = value.get_num() / value.get_den();
    EXPECT_EQ(truncated_double(whole), std::isfinite(nearest) ? std::trunc(cut) : nearest) << text;
  }
}

TEST(WrittenDouble, TellsWhatDoublesLose) {
  for (const char* text : {"0", "1", "-1/3", "5e-324", "1e308", "3e-324"}) {
    const double written = written_double(number(text));
    EXPECT_EQ(written, to_double(number(text))) << text;
    EXPECT_EQ(written_problem(written), "") << text;
    EXPECT_NO_THROW(require_double(written, "it"));
  }
  for (const char* text : {"2e-324", "-2e-324", "1e-400", "1e-4000"})
    EXPECT_EQ(written_problem(written_double(number(text))), "is below the range of doubles") << text;
  for (const char* text : {"1e309", "-1e309", "1e4000"})
    EXPECT_EQ(written_problem(written_double(number(text))), "is beyond the range of doubles") << text;
  EXPECT_EQ(required_double(Rounded{}, "it"), 0);
  EXPECT_EQ(required_double({0.5, 1}, "it"), 0.5);
  try {
    required_double({0, 1}, "the area of 'a'");
    FAIL() << "lost";
  } catch (const RequestError& error) {
    EXPECT_STREQ(error.what(), "the area of 'a' is below the range of doubles");
  }
}

}  // namespace
}  // namespace hottel::exact_double_test
