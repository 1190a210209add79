#include "viewer/edit/decimals.h"

#include <cmath>
#include <cstdlib>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

Rational power_of_ten(int exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(1 / Rational(power)) : Rational(power);
}

}  // namespace

int decades(const Rational& value) {
  HOTTEL_REQUIRE(value > 0);
  // mpz_sizeinbase is the number of digits, or one more.
  int k = static_cast<int>(mpz_sizeinbase(value.get_num_mpz_t(), 10)) -
          static_cast<int>(mpz_sizeinbase(value.get_den_mpz_t(), 10)) - 2;
  while (value > power_of_ten(k)) ++k;
  return k;
}

int decimals_at(double pixels_per_length) {
  HOTTEL_REQUIRE(std::isfinite(pixels_per_length) && pixels_per_length > 0);
  return -decades(kLeastPixelsPerStep / exact_value(pixels_per_length));
}

Rational decimal_step(int decimals) { return power_of_ten(-decimals); }

Rational rounded_decimal(const Rational& value, int decimals) {
  const Rational unit = power_of_ten(decimals), scaled = value * unit + Rational(1, 2);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(whole) / unit;
}

Rational rounded_decimal(double value, int decimals) {
  HOTTEL_REQUIRE(std::isfinite(value));
  return rounded_decimal(exact_value(value), decimals);
}

}  // namespace hottel
