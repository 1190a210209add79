// Vectors of three numbers and the signs of their products: in doubles with proven bounds, then in integers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernel/int128.h"
#include "kernel/rational.h"
#include "kernel/tier.h"

namespace hottel {

// A vector of three integers.
struct IntegerVector {
  Integer x, y, z;
  friend bool operator==(const IntegerVector&, const IntegerVector&) = default;
};

IntegerVector cross(const IntegerVector& a, const IntegerVector& b);
// The same, into a vector whose memory is used again. REQUIRES: the result is neither a nor b.
void set_cross(IntegerVector& result, const IntegerVector& a, const IntegerVector& b);
Integer dot(const IntegerVector& a, const IntegerVector& b);
// Returns a - b, a + b, -a and factor * a.
IntegerVector difference(const IntegerVector& a, const IntegerVector& b);
IntegerVector sum(const IntegerVector& a, const IntegerVector& b);
IntegerVector opposite(const IntegerVector& a);
IntegerVector multiple(const Integer& factor, const IntegerVector& a);
bool is_zero(const IntegerVector& a);

// Returns the vector of coprime integers in the same direction; zero for zero.
IntegerVector primitive(const IntegerVector& a);

// The bits of the largest component; 0 for zero.
long bits(const IntegerVector& a);

// The sign of the scalar product.
int dot_sign(const IntegerVector& a, const IntegerVector& b);

// The sign of the determinant with these rows.
int determinant_sign(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c);

// A vector of three real numbers of which doubles are known.
//
//   (1) each real number is within error of its double, and no double is larger than size in absolute value
//   (2) error == 0: the doubles are integers, and they are the numbers
struct BoundedVector {
  double x = 0, y = 0, z = 0;
  double size = 0, error = 0;
};

// Returns a * 2^-shift in doubles, off by at most 2^-52 size where that is not an integer that fits, and by an absolute
// 2^-1000 where doubles underflow. REQUIRES: the result is below 2^200.
BoundedVector rounded(const IntegerVector& a, long shift);

// Returns a / b * 2^-shift in doubles, b > 0, off by at most 2^-50 of itself, however long a and b are: either may be
// larger than any double. 0 or infinite where the result is below or above all normal doubles.
double rounded_quotient(const Integer& a, const Integer& b, long shift);

namespace detail {
inline constexpr double kUnit = 0x1p-53;         // largest relative error of one operation
inline constexpr double kUnderflow = 0x1p-1000;  // above the sum of all absolute errors of products that underflow

// The error of a product of two components where the factors are off.
inline double carried_error(const BoundedVector& a, const BoundedVector& b) {
  return a.size * b.error + b.size * a.error + a.error * b.error;
}
}  // namespace detail

// The cross product, with its bound. REQUIRES: the product of both sizes is below 2^1000.
//
// Each component is the rounded difference of two rounded products: 2 u of the sum of their absolute values, so 4 u
// of the product of the sizes; and twice what the errors of the factors make in a product. Where both vectors are
// integers and that product is at most 2^52 nothing is rounded.
inline BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
  BoundedVector c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  c.size = std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
  const double sizes = a.size * b.size;
  if (a.error == 0 && b.error == 0 && sizes <= 0x1p52) return c;
  c.error = 4.01 * detail::kUnit * sizes + 2.001 * detail::carried_error(a, b) + detail::kUnderflow;
  return c;
}

// The determinant with these rows. REQUIRES that all three are small integers: is_small_integer().
Int128 small_determinant(const BoundedVector& a, const BoundedVector& b, const BoundedVector& c);
inline bool is_small_integer(const BoundedVector& a) { return a.error == 0 && a.size < 0x1p40; }

// A real number of which a double is known, and how far off it is at most; 0 where it is the number.
struct BoundedValue {
  double value = 0, error = 0;
};

// The scalar product, with its bound.
//
// Three rounded products and two sums: 3 u (1 + u) of the sum of absolute values, so 9 u of the product of the sizes.
// Where both vectors are integers and that product is at most 2^51 nothing is rounded.
// REQUIRES: the product of both sizes is below 2^1000.
inline BoundedValue dot(const BoundedVector& a, const BoundedVector& b) {
  const double sizes = a.size * b.size;
  const bool is_exact = a.error == 0 && b.error == 0 && sizes <= 0x1p51;
  return {a.x * b.x + a.y * b.y + a.z * b.z,
          is_exact ? 0 : 9.01 * detail::kUnit * sizes + 3.001 * detail::carried_error(a, b) + detail::kUnderflow};
}

inline constexpr int kUndecided = 2;

// The sign of the real number, or kUndecided.
inline int sign_of(const BoundedValue& number) {
  if (number.value > number.error) return 1;
  if (number.value < -number.error) return -1;
  return number.error == 0 ? 0 : kUndecided;
}

// The sign of the scalar product of the real vectors, or kUndecided.
//
//   (1) never wrong, whatever the numbers within both error bounds are
//   (2) small integers are always decided, zero included
inline int filtered_sign(const BoundedVector& a, const BoundedVector& b) { return sign_of(dot(a, b)); }

}  // namespace hottel
