// 128-bit integers, and the few conversions to doubles that exact sums need.
#pragma once

#include <gmpxx.h>

#include <bit>
#include <cstdint>

namespace hottel {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

// A number as an unevaluated sum hi + lo with |lo| <= ulp(hi)/2: about 106 significant bits.
struct DoubleDouble {
  double hi = 0, lo = 0;
};

// Returns a double near value, off by at most 2^-51 |value|; exact for |value| <= 2^53. (The compiler's own conversion
// is a slow call. Both halves are signed: of an unsigned one x86 asks whether its upper bit is set, which any number
// may answer either way.)
// REQUIRES: |value| < 2^126.
inline double double_near(Int128 value) {
  const auto low = static_cast<std::int64_t>(value);
  const auto high = static_cast<std::int64_t>(value >> 64) + (low < 0 ? 1 : 0);
  return static_cast<double>(high) * 0x1p64 + static_cast<double>(low);
}

// Returns value as a double-double: exact for |value| < 2^106, otherwise off by up to 2^-103 |value|.
// REQUIRES: |value| < 2^126.
inline DoubleDouble to_double_double(Int128 value) {
  const auto high = static_cast<std::uint64_t>((value < 0 ? -value : value) >> 64);
  // The top 53 bits (or fewer), exactly; the rest is below 2^74.
  const int shift = high == 0 ? 11 : 75 - std::countl_zero(high);
  const auto top = static_cast<std::int64_t>(value >> shift);
  const Int128 rest = value - (static_cast<Int128>(top) << shift);
  const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + shift) << 52);
  const double hi = static_cast<double>(top) * unit;
  const double lo = static_cast<double>(static_cast<std::int64_t>(rest >> 21)) * 0x1p21 +
                    static_cast<double>(static_cast<std::int64_t>(rest & 0x1fffff));
  const double sum = hi + lo;
  return {sum, lo - (sum - hi)};
}

// Returns the same number, exactly, for every value of the type.
inline mpz_class to_integer(Int128 value) {
  const bool negative = value < 0;
  const UInt128 magnitude = negative ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
  mpz_class result(static_cast<unsigned long>(magnitude >> 64));
  result <<= 64;
  result += static_cast<unsigned long>(magnitude);
  return negative ? mpz_class(-result) : result;
}

// Splits a sum: s + e = a + b exactly, s the rounded sum, whichever of a and b is larger (Knuth).
// REQUIRES: rounding to nearest, and no overflow.
constexpr void two_sum(double a, double b, double& s, double& e) {
  s = a + b;
  const double t = s - a;
  e = (a - (s - t)) + (b - t);
}

// Splits a product: p + e = a * b exactly, p the rounded product (Dekker). It gives the same on machines with and
// without a fused multiply-add. Where the error is too small for a double, p + e is only near a * b.
// REQUIRES: rounding to nearest, |a|, |b| < 2^990, and no overflow.
constexpr void two_product(double a, double b, double& p, double& e) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  p = a * b;
  const double ca = kSplitter * a, ah = ca - (ca - a), al = a - ah;
  const double cb = kSplitter * b, bh = cb - (cb - b), bl = b - bh;
  e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}

}  // namespace hottel
