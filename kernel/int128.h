// 128-bit integers, and the few conversions to doubles that exact sums need.
#pragma once

#include <gmpxx.h>

#include <cstdint>

namespace hottel {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

// A number as an unevaluated sum hi + lo, |lo| <= ulp(hi)/2.
struct DoubleDouble {
  double hi = 0, lo = 0;
};

// Exact for |value| < 2^106; otherwise the nearest such pair, up to 2^-106 |value|.
inline DoubleDouble to_double_double(Int128 value) {
  const double hi = static_cast<double>(value);
  return {hi, static_cast<double>(value - static_cast<Int128>(hi))};
}

inline mpz_class to_integer(Int128 value) {
  const bool negative = value < 0;
  const UInt128 magnitude = negative ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
  mpz_class result(static_cast<unsigned long>(magnitude >> 64));
  result <<= 64;
  result += static_cast<unsigned long>(magnitude);
  return negative ? mpz_class(-result) : result;
}

// s + e = a + b exactly, s the rounded sum.
inline void two_sum(double a, double b, double& s, double& e) {
  s = a + b;
  const double t = s - a;
  e = (a - (s - t)) + (b - t);
}

// p + e = a * b exactly, p the rounded product. Dekker's product: the same result on machines with and without
// a fused multiply-add. REQUIRES |a|, |b| < 2^990.
inline void two_product(double a, double b, double& p, double& e) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  p = a * b;
  const double ca = kSplitter * a, ah = ca - (ca - a), al = a - ah;
  const double cb = kSplitter * b, bh = cb - (cb - b), bl = b - bh;
  e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}

}  // namespace hottel
