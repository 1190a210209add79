#include "kernel/rounded_share.h"

#include "kernel/nearest_double.h"
#include "kernel/support/failure.h"

namespace hottel {

RoundedShare::RoundedShare(const Rational& origin, const Rational& extent) {
  HOTTEL_REQUIRE(extent > 0);
  scale_ = origin.get_den() * extent.get_den();
  shift_ = origin.get_num() * extent.get_den();
  divisor_ = origin.get_den() * extent.get_num();
}

double RoundedShare::of(const Rational& value) const {
  thread_local Integer numerator, denominator;  // kept, so that their memory is
  mpz_mul(numerator.get_mpz_t(), value.get_num().get_mpz_t(), scale_.get_mpz_t());
  mpz_submul(numerator.get_mpz_t(), value.get_den().get_mpz_t(), shift_.get_mpz_t());
  mpz_mul(denominator.get_mpz_t(), value.get_den().get_mpz_t(), divisor_.get_mpz_t());
  return nearest_double(numerator, denominator);
}

}  // namespace hottel
