#include "geometry/space/vectors/integer_reals.h"

#include <algorithm>
#include <cmath>

#include "kernel/exact_double.h"

namespace hottel::integer_reals {
namespace {

constexpr long kFractionBits = 128;
constexpr long kMostExponent = 30000;  // beyond any of long double

// The number value * 2^-bits: by parts of 53 bits, so off by at most 2^-62 of it.
long double in_long_double(Integer value, long bits) {
  long double sum = 0;
  for (int part = 0; part < 3 && value != 0; ++part) {
    long exponent;
    const double leading = mpz_get_d_2exp(&exponent, value.get_mpz_t());  // towards zero
    sum += std::ldexp(static_cast<long double>(leading),
                      static_cast<int>(std::clamp(exponent - bits, -kMostExponent, kMostExponent)));
    const Integer digits = exact_integer(std::ldexp(leading, 53));
    value -= exponent >= 53 ? Integer(digits << static_cast<unsigned long>(exponent - 53))
                            : Integer(digits >> static_cast<unsigned long>(53 - exponent));
  }
  return sum;
}

void set_by_mpfr(const Integer& top, const Integer& bottom, long bits, mpfr_t& number) {
  mpfr_set_z(number, top.get_mpz_t(), MPFR_RNDN);
  mpfr_div_z(number, number, bottom.get_mpz_t(), MPFR_RNDN);
  mpfr_mul_2si(number, number, -bits, MPFR_RNDN);
}

long length_of(const Integer& value) { return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

}  // namespace

void set_quotient(const Integer& top, const Integer& bottom, long bits, long double& result) {
  if (bottom == 1) {
    result = in_long_double(top, bits);
    return;
  }
  // The quotient has so many bits at least.
  const long more = kFractionBits + std::max(0L, length_of(bottom) - length_of(top));
  result = in_long_double((top << static_cast<unsigned long>(more)) / bottom, more + bits);
}

void set_quotient(const Integer& top, const Integer& bottom, long bits, LongerReal& result) {
  set_by_mpfr(top, bottom, bits, result.backend().data());
}
void set_quotient(const Integer& top, const Integer& bottom, long bits, WideReal& result) {
  set_by_mpfr(top, bottom, bits, result.backend().data());
}

}  // namespace hottel::integer_reals
