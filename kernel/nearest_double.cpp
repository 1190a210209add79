#include "kernel/nearest_double.h"

#include <cmath>
#include <cstdint>

namespace hottel {
namespace {

constexpr long kQuotientBits = 62;  // at least: more than a double has, and one more at most fits into 64
static_assert(sizeof(mp_limb_t) == sizeof(std::uint64_t));

}  // namespace

double nearest_double(const mpz_class& numerator, const mpz_class& denominator) {
  const int sign = sgn(numerator);
  if (sign == 0) return 0.0;
  thread_local mpz_class scaled, divisor, remainder;  // kept, so that their memory is
  const auto bits = [](const mpz_class& z) { return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2)); };
  const long shift = kQuotientBits - (bits(numerator) - bits(denominator));
  mpz_abs(scaled.get_mpz_t(), numerator.get_mpz_t());
  divisor = denominator;
  if (shift >= 0)
    scaled <<= static_cast<unsigned long>(shift);
  else
    divisor <<= static_cast<unsigned long>(-shift);
  mpz_tdiv_qr(scaled.get_mpz_t(), remainder.get_mpz_t(), scaled.get_mpz_t(), divisor.get_mpz_t());
  // The value is quotient * 2^-shift, and more where something remains. Keep 53 bits, or fewer where the result is
  // subnormal.
  const std::uint64_t quotient = mpz_getlimbn(scaled.get_mpz_t(), 0);
  const long size = bits(scaled);
  const long top = size - shift;  // the value is in [2^(top-1), 2^top)
  const long keep = top - 53 < -1074 ? top + 1074 : 53;
  if (keep < 0) return sign * 0.0;
  const long drop = size - keep;
  if (drop - shift > 2000) return sign * HUGE_VAL;
  std::uint64_t kept = quotient >> drop;
  const std::uint64_t rest = quotient - (kept << drop), half = std::uint64_t{1} << (drop - 1);
  if (rest > half || (rest == half && (remainder != 0 || kept % 2 == 1))) ++kept;
  return sign * std::ldexp(static_cast<double>(kept), static_cast<int>(drop - shift));
}

}  // namespace hottel
