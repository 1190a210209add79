// The rounding ladder: from sums with an error bound to the correctly rounded double.
#pragma once

#include <cstdint>
#include <optional>

#include "kernel/enclosure.h"
#include "kernel/int128.h"
#include "kernel/rational.h"
#include "kernel/root_sum.h"
#include "kernel/tier.h"

namespace hottel {

// A sum of lengths in fixed point: the real number lies within error of value (both in the same unit).
struct FixedSum {
  Int128 value = 0;
  double error = 0;
};

// A number and the tier that settled it.
struct RoundedByTier {
  Rounded number;
  Tier tier;
};

class FixedDivisor;

// A dividend, prepared for some quotients.
class FixedDividend {
 public:
  // REQUIRES |value| < 2^126.
  FixedDividend(const FixedSum& sum) : sum_(sum), value_(to_double_double(sum.value)) {}

  // True unless it is greater than its error.
  bool may_be_zero() const { return value_.hi <= sum_.error; }

 private:
  friend class FixedDivisor;
  friend std::optional<RoundedByTier> round_quotient(const FixedDividend& numerator, const FixedDivisor& denominator);
  FixedSum sum_;
  DoubleDouble value_;
};

// A divisor, prepared for many quotients.
class FixedDivisor {
 public:
  FixedDivisor() = default;  // one that fits nothing
  // REQUIRES |value| < 2^126.
  explicit FixedDivisor(const FixedSum& sum);

  // True iff it is greater than its error: only then something is divided by it.
  bool is_usable() const { return inverse_ > 0; }

 private:
  friend std::optional<RoundedByTier> round_quotient(const FixedDividend& numerator, const FixedDivisor& denominator);
  FixedDividend number_ = FixedSum{};
  double inverse_ = 0, relative_error_ = 0;
};

// Returns numerator / denominator correctly rounded, or nothing when the error bounds do not allow it: a tie, a
// quotient that is a double, heavy cancellation.
//
//   (1) what is returned is correctly rounded whatever the numbers within both error bounds are
//   (2) without errors, or of a zero without error, the tier is kDouble and there always is a result
//
// REQUIRES: a divisor that is usable.
// COST: a few dozen operations on doubles, none of them a division, unless both errors are 0: then a rational is made
// and rounded.
std::optional<RoundedByTier> round_quotient(const FixedDividend& numerator, const FixedDivisor& denominator);
// The same of numbers that are divided once. REQUIRES: |value| < 2^126 of both.
inline std::optional<RoundedByTier> round_quotient(const FixedSum& numerator, const FixedSum& denominator) {
  return round_quotient(FixedDividend(numerator), FixedDivisor(denominator));
}

// An exact unit, prepared for turning fixed-point sums into doubles.
class FixedScale {
 public:
  explicit FixedScale(const Rational& unit);  // REQUIRES unit > 0

 private:
  friend std::optional<RoundedByTier> round_scaled(const FixedDividend& sum, const FixedScale& scale);
  FixedDivisor divisor_;  // unit = 2^exponent / divisor
  long exponent_;
};

// Returns sum * unit correctly rounded, or nothing when the error bounds (or the range of double) do not allow it.
std::optional<RoundedByTier> round_scaled(const FixedDividend& sum, const FixedScale& scale);

// Returns numerator / denominator correctly rounded, always.
//
//   (1) ties and quotients that are doubles are recognised as such, by the canonical sum
//   (2) where the nearest double is infinite, so is the value, and side points back to the real number
//
// Throws ContractViolation when the denominator is zero.
// REQUIRES: denominator > 0.
// COST: balls of 128 bits, then of twice as many each time until they settle it.
RoundedByTier round_quotient(const RootSum& numerator, const RootSum& denominator);

}  // namespace hottel
