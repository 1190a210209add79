// Exact numbers as they were typed.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

namespace hottel {

using Integer = mpz_class;
using Rational = mpq_class;

// What is allowed in a number that a user types. Beyond these limits a text is refused, never rounded.
inline constexpr std::size_t kMaxNumberLength = 4096;
inline constexpr long kMaxNumberExponent = 4096;

// Returns the exact value of a number as a user types it: an integer ("12"), a decimal with optional exponent ("-0.1",
// "2.5e-3", ".5"), or a fraction of integers ("4/3"). A sign may be + or -.
//
//   (1) "0.1" is one tenth, not the double nearest to it
//   (2) the value is canonical: lowest terms, positive denominator
//
// Returns nothing when the text is not such a number, is longer than kMaxNumberLength, has an exponent beyond
// kMaxNumberExponent in absolute value, or has the denominator 0. Surrounding blanks are not allowed.
std::optional<Rational> parse_rational(std::string_view text);

// Returns "p" or "p/q" in lowest terms; parse_rational reads it back to the same value when it is within the limits.
std::string to_string(const Rational& value);

// Returns the double nearest to value, ties to even. (mpq_class::get_d truncates.)
//
//   (1) beyond the largest double by half an ulp or more: infinity with the sign of value
//   (2) subnormal results are correctly rounded too; a negative number that rounds to 0 gives -0.0
double to_double(const Rational& value);

// Returns value * 2^shift, exactly and in lowest terms; shift may be negative.
Rational scaled_by_power_of_two(const Rational& value, long shift);

// Returns the shortest decimal that reads back to exactly this double, as std::to_chars writes it.
std::string shortest(double value);

}  // namespace hottel
