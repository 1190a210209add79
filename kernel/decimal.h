// Numbers as decimals for people, also beyond the range of doubles.
#pragma once

#include <string>

#include "kernel/rational.h"
#include "kernel/root_sum.h"

namespace hottel {

// Returns the shortest decimal that reads back to the double nearest to `value`.
//
//   (1) beyond the range of doubles, where that would be inf or 0, the decimal goes on: "1.2e+801", "-3e-400"; it is
//       off by less than 2^-52 of the number there
//   (2) "0" iff the number is 0
std::string decimal_text(const RootSum& value);
std::string decimal_text(const Rational& value);

// Returns the number as shortly as it can be said.
//
//   (1) the decimal of decimal_text when that is exact
//   (2) else p/q when that has at most 11 characters
//   (3) else the decimal all the same: the one case that is not exact
std::string short_text(const Rational& value);

// Returns sqrt(squared), correctly rounded, as its shortest decimal. REQUIRES squared >= 0.
std::string length_text(const Rational& squared);

}  // namespace hottel
