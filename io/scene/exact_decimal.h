// Numbers as decimals that are exact.
#pragma once

#include <optional>
#include <string>

#include "kernel/rational.h"

namespace hottel {

// value = digits * 10^exponent.
struct Decimal {
  Integer digits;
  long exponent = 0;
};

// Returns a value as a decimal, exactly: as an integer times a power of ten whose exponent is not above 0 unless the
// digits end in no 0. Nothing where there is no such form, as of 1/3.
std::optional<Decimal> exact_decimal(const Rational& value);

// Returns the decimal as text, without an exponent if it is short ("-0.125", "1200"), else with one ("1e-30").
// parse_rational reads it back to the same value. Nothing where there is no such form, or where parse_rational would
// not read it: it is longer than kMaxNumberLength, or its exponent beyond kMaxNumberExponent.
std::optional<std::string> exact_decimal_text(const Rational& value);

}  // namespace hottel
