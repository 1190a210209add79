// Short numbers near what a hand points at.
#pragma once

#include "kernel/rational.h"

namespace hottel {

// The least length on the screen of a step from one decimal to the next. [pixels]
inline constexpr int kLeastPixelsPerStep = 4;

// Returns d such that 10^-d is the finest power of ten that is at least kLeastPixelsPerStep pixels long; negative where
// the steps are tens, hundreds and so on. Exact: d is the greatest with kLeastPixelsPerStep * 10^d <=
// pixels_per_length. REQUIRES: a finite number above 0.
int decimals_at(double pixels_per_length);

// Returns 10^-decimals, exactly.
Rational decimal_step(int decimals);

// Returns the multiple of 10^-decimals that is nearest to `value`, the greater one of two.
//
//   (1) exactly the decimal: 0.1 at one decimal is one tenth, not the double nearest to it
//   (2) decimals may be negative: at -2 the result is a multiple of 100
// REQUIRES: `value` is finite.
Rational rounded_decimal(const Rational& value, int decimals);
Rational rounded_decimal(double value, int decimals);

// Returns the least k, of either sign, with value <= 10^k. REQUIRES: value > 0.
int decades(const Rational& value);

}  // namespace hottel
