// Real numbers enclosed to about 100 bits: what the certificate of a solution reckons with.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kernel/doubles.h"
#include "kernel/enclosure.h"
#include "kernel/exact_double.h"
#include "kernel/int128.h"
#include "kernel/rational.h"

namespace hottel {

// A real number within radius of hi + lo.
//
//   (1) every operation returns an enclosure of the result for every number in its operands, whatever the rounding
//       mode and however the compiler moves code: all rounding errors are bounded, none is directed
//   (2) REQUIRES |values| < 2^900; numbers below 2^-1070 are lost in the radius
struct DoubleDoubleBall {
  double hi = 0, lo = 0, radius = 0;

  // Enclosures of one real number: a rational, to about 106 bits; a sum of two doubles, exactly; a number that was
  // rounded to a double; and one of which only bounds are known.
  static DoubleDoubleBall of(const Rational& value);  // any number, where it is beyond the range of doubles
  static DoubleDoubleBall of(DoubleDouble value) { return {value.hi, value.lo, 0}; }
  static DoubleDoubleBall of(const Rounded& value);  // on the side that is known, as far as half-way to the next double
  static DoubleDoubleBall around(DoubleDouble value, const Enclosure& bounds);  // any number within the bounds

  double value() const { return hi + lo; }
  double size() const { return std::abs(hi) + std::abs(lo) + radius; }  // not below any number in it, to 2 ulps
  double lower() const;                                                 // a double not above any number in it
  double upper() const;                                                 // a double not below any number in it
};

inline constexpr double kBallRoundoff = 0x1p-53;  // of one operation, relative
inline constexpr double kUnderflow = 0x1p-1070;   // of a few operations, absolute
inline constexpr double kOutward = 1 + 0x1p-48;   // more than the roundings of a radius

// Enclosures of a + b, -a, a - b and a b. That of -a has the radius of a.       COST: about 10 ns each.
inline DoubleDoubleBall sum(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
  double s, e;
  two_sum(a.hi, b.hi, s, e);
  const double low = e + (a.lo + b.lo);
  const double error = 4 * kBallRoundoff * (std::abs(e) + std::abs(a.lo) + std::abs(b.lo));
  DoubleDoubleBall result;
  two_sum(s, low, result.hi, result.lo);
  result.radius = (a.radius + b.radius + error) * kOutward + kUnderflow;
  return result;
}

inline DoubleDoubleBall negated(const DoubleDoubleBall& a) { return {-a.hi, -a.lo, a.radius}; }
inline DoubleDoubleBall difference(const DoubleDoubleBall& a, const DoubleDoubleBall& b) { return sum(a, negated(b)); }

inline DoubleDoubleBall product(const DoubleDoubleBall& a, const DoubleDoubleBall& b) {
  double p, e;
  two_product(a.hi, b.hi, p, e);
  const double cross = a.hi * b.lo, other = a.lo * b.hi;
  const double low = e + (cross + other);
  const double error =
      4 * kBallRoundoff * (std::abs(e) + std::abs(cross) + std::abs(other)) + std::abs(a.lo) * std::abs(b.lo);
  DoubleDoubleBall result;
  two_sum(p, low, result.hi, result.lo);
  result.radius = (a.size() * b.radius + b.size() * a.radius + error) * kOutward + kUnderflow;
  return result;
}

inline DoubleDoubleBall DoubleDoubleBall::of(const Rational& value) {
  DoubleDoubleBall result;
  result.hi = to_double(value);
  if (std::isinf(result.hi)) return {0, 0, std::numeric_limits<double>::infinity()};
  const Rational rest = value - exact_value(result.hi);
  result.lo = to_double(rest);
  if (rest != exact_value(result.lo)) result.radius = std::abs(result.lo) * (2 * kBallRoundoff) + kUnderflow;
  return result;
}

inline DoubleDoubleBall DoubleDoubleBall::of(const Rounded& value) {
  if (value.side == 0) return {value.value, 0, 0};
  // The real number lies between the double and half-way to its neighbour on that side.
  const auto bits = std::bit_cast<std::uint64_t>(value.value);
  const double neighbour = std::bit_cast<double>(value.side > 0 ? bits + 1 : bits - 1);
  const double quarter = std::abs(neighbour - value.value) / 4;
  if (quarter < kUnderflow) return {value.value, 0, kUnderflow};
  return {value.value, value.side > 0 ? quarter : -quarter, quarter};
}

inline DoubleDoubleBall DoubleDoubleBall::around(DoubleDouble value, const Enclosure& bounds) {
  const double reach = std::max(bounds.upper - value.hi, value.hi - bounds.lower);
  return {value.hi, value.lo, (reach + std::abs(value.lo)) * kOutward};
}

// Returns a 2^exponent, exactly where doubles allow it. REQUIRES a result within their range; what is below 2^-1070 is
// lost, in the radius.
inline DoubleDoubleBall scaled(const DoubleDoubleBall& a, int exponent) {
  if (exponent == 0 || a.size() == 0) return a;
  DoubleDoubleBall result{std::ldexp(a.hi, exponent), std::ldexp(a.lo, exponent), std::ldexp(a.radius, exponent)};
  const auto is_kept = [exponent](double from, double to) { return std::ldexp(to, -exponent) == from; };
  if (!is_kept(a.hi, result.hi) || !is_kept(a.lo, result.lo) || !is_kept(a.radius, result.radius))
    result.radius += kUnderflow;
  return result;
}

// Return a double not above (not below) value 2^exponent.
inline double lower_scaled(double value, int exponent) {
  const double result = std::ldexp(value, exponent);
  return std::isfinite(result) && std::ldexp(result, -exponent) <= value
             ? result
             : std::nextafter(result, -std::numeric_limits<double>::infinity());
}
inline double upper_scaled(double value, int exponent) { return -lower_scaled(-value, exponent); }

inline double DoubleDoubleBall::upper() const {
  const double rest = radius == 0 ? lo : std::nextafter(lo + radius, kInfinity);
  double s, e;
  two_sum(hi, rest, s, e);
  return e > 0 ? std::nextafter(s, kInfinity) : s;
}

inline double DoubleDoubleBall::lower() const { return -negated(*this).upper(); }

}  // namespace hottel
