// Numbers with so many significant digits, as csv holds them.
#pragma once

#include <optional>
#include <string>

namespace hottel {

// The most digits that one may ask for: as many as tell any double.
inline constexpr int kMostDigits = 17;

// How a number that needs more digits is rounded.
enum class RoundedTo : unsigned char { kNearest, kBelow, kAbove };

// Returns a number as a decimal of at most so many significant digits.
//
//   (1) where its shortest decimal has no more, or no number of digits is asked for: that, which reads back to the same
//       double (large whole numbers have an exponent then)
//   (2) else, to the nearest: the decimal nearest to the double, ties to even
//   (3) else, below and above: the nearest decimals on either side of the double; so the double that is read back is
//       not above, and not below, the one that was written: bounds stay bounds
//   (4) beyond the largest double there is no decimal: "inf"
//
// What is not finite stays as it is. Throws ContractViolation for digits outside 1 to kMostDigits.
std::string short_digits(double value, std::optional<int> digits, RoundedTo to = RoundedTo::kNearest);

// The same of a visibility: what is below 1 is not written as 1.
std::string short_visibility(double value, std::optional<int> digits);

}  // namespace hottel
