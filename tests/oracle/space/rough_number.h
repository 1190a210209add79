// A number known up to an error, in doubles: for filters before exact oracles.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>

namespace hottel::oracle {

// A double, and how far the real number may be from it at most. A result holds what exact numbers within the errors of
// its operands come to, in expressions like those of rays: differences, and products of at most six of them.
//
// WHY: a rounded sum or product is off by at most u |result|, u = 2^-53, where it neither underflows nor overflows; the
// rest of each error is what the errors of the operands come to. An error is made in at most five rounded steps from
// numbers that are not negative, so it is at least (1 - u)^5 of what it stands for: the factor kUp makes up for that.
// Nothing underflows: numbers made of rationals are 0, or at least 2^-60 or of such an error. So differences of two are
// multiples of 2^-112; those of products of two are of 2^-276, of three 2^-440, of six 2^-932, and u times that is more
// than 2^-1022. Errors that are not 0 are at least as large. Nothing overflows: numbers up to 2^80 come to 2^500.
struct RoughNumber {
  double value = 0, error = 0;

  static RoughNumber of(const mpq_class& exact) {
    if (sgn(exact) == 0) return {};
    const double value = exact.get_d(), size = std::fabs(value);  // cut off: off by less than 2 u size
    if (size < kLeast) return {0, 2 * kLeast};
    if (!(size <= kMost)) return {0, std::numeric_limits<double>::infinity()};
    return {value, 2 * kUnit * size};
  }

  // The sign of the real number, 0 where the error does not tell it. A NaN or an infinite error tells nothing.
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }

  friend RoughNumber operator+(const RoughNumber& a, const RoughNumber& b) {
    const double value = a.value + b.value;
    return {value, kUp * (a.error + b.error + kUnit * std::fabs(value))};
  }
  friend RoughNumber operator-(const RoughNumber& a, const RoughNumber& b) {
    return a + RoughNumber{-b.value, b.error};
  }
  friend RoughNumber operator*(const RoughNumber& a, const RoughNumber& b) {
    const double value = a.value * b.value;
    return {value,
            kUp * (std::fabs(a.value) * b.error + a.error * (std::fabs(b.value) + b.error) + kUnit * std::fabs(value))};
  }

 private:
  static constexpr double kUnit = 0x1p-53, kUp = 1 + 0x1p-49, kLeast = 0x1p-60, kMost = 0x1p80;
};

struct RoughVector {
  RoughNumber x, y, z;

  friend RoughVector operator-(const RoughVector& a, const RoughVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

inline RoughNumber dot(const RoughVector& a, const RoughVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline RoughVector cross(const RoughVector& a, const RoughVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace hottel::oracle
