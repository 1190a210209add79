// Real numbers of any size, enclosed to about 100 bits.
#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>

#include "kernel/doubles.h"
#include "solver/radiosity/double_double_ball.h"

namespace hottel {

// A real number within mantissa 2^exponent.
//
//   (1) sums and products enclose theirs, as those of Enclosed do; numbers of any size lose no digits, since the
//       mantissa of every result is brought near 1
//   (2) what is exactly 0 leaves a sum as it is
//   (3) lower() and upper() are doubles; infinite where no bound is known or doubles end
struct ScaledBall {
  DoubleDoubleBall mantissa;
  int exponent = 0;

  // From a number, exactly where a mantissa of two doubles holds it; 0 is 0. The exponents of doubles are no limit.
  static ScaledBall of(const Rational& value);
  // Any number from lower to upper: of(lower) where they are equal. REQUIRES 0 <= lower <= upper.
  static ScaledBall around(const Rational& lower, const Rational& upper);
  static ScaledBall of(const DoubleDoubleBall& value, int exponent = 0) {
    return ScaledBall{value, exponent}.near_one();
  }

  // Whether nothing but 0 is enclosed.
  bool is_zero() const { return mantissa.size() == 0; }
  // A double near the middle of what is enclosed; infinite beyond the range of doubles.
  double nearest() const { return std::ldexp(mantissa.value(), exponent); }
  double lower() const { return -negated(*this).upper(); }
  double upper() const { return std::isfinite(mantissa.size()) ? upper_scaled(mantissa.upper(), exponent) : kInfinity; }

  // The mantissa in units of 2^unit.
  DoubleDoubleBall in_unit(int unit) const { return scaled(mantissa, exponent - unit); }

  // The same number with a mantissa of size 1 to 2; 0 is 0 times 1. A mantissa that is not finite stays as it is.
  ScaledBall near_one() const {
    const double size = mantissa.size();
    if (size == 0) return {};
    if (!std::isfinite(size)) return *this;
    const int shift = std::ilogb(size);
    return {scaled(mantissa, -shift), exponent + shift};
  }

  friend ScaledBall negated(const ScaledBall& a) { return {hottel::negated(a.mantissa), a.exponent}; }
};

// Enclosures of a + b, a - b and a b; 0 times anything is 0.
inline ScaledBall sum(const ScaledBall& a, const ScaledBall& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const int unit = std::max(a.exponent, b.exponent);
  return ScaledBall::of(sum(a.in_unit(unit), b.in_unit(unit)), unit);
}

inline ScaledBall difference(const ScaledBall& a, const ScaledBall& b) { return sum(a, negated(b)); }

inline ScaledBall product(const ScaledBall& a, const ScaledBall& b) {
  if (a.is_zero() || b.is_zero()) return {};
  return ScaledBall::of(product(a.mantissa, b.mantissa), a.exponent + b.exponent);
}

// 2^exponent near value > 0.
inline int exponent_of(const Rational& value) {
  return static_cast<int>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) -
         static_cast<int>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

inline ScaledBall ScaledBall::of(const Rational& value) {
  if (value == 0) return {};
  const int exponent = exponent_of(value);
  return {DoubleDoubleBall::of(scaled_by_power_of_two(value, -exponent)), exponent};
}

inline ScaledBall ScaledBall::around(const Rational& lower, const Rational& upper) {
  if (lower == upper) return of(lower);
  const int exponent = exponent_of(upper);
  const Rational reach = scaled_by_power_of_two(upper - lower, -exponent - 1);
  ScaledBall result{DoubleDoubleBall::of(Rational(scaled_by_power_of_two(lower, -exponent) + reach)), exponent};
  const double reach_above = std::nextafter(to_double(reach), std::numeric_limits<double>::infinity());
  result.mantissa.radius = (result.mantissa.radius + reach_above) * kOutward;
  return result;
}

}  // namespace hottel
