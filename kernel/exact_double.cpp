#include "kernel/exact_double.h"

#include <cmath>
#include <limits>

#include "kernel/support/failure.h"

namespace hottel {

double finite(double value) {
  if (!std::isfinite(value)) throw RequestError("a number that comes out of this scene is beyond the range of doubles");
  return value;
}

Rational exact_value(double value) { return Rational(finite(value)); }

Integer exact_integer(double value) { return Integer(finite(value)); }

double truncated_double(const Integer& value) {
  constexpr std::size_t kMostBits = std::numeric_limits<double>::max_exponent;
  if (mpz_size(value.get_mpz_t()) <= 1) return value.get_d();
  if (mpz_sizeinbase(value.get_mpz_t(), 2) > kMostBits) return sgn(value) * HUGE_VAL;
  return value.get_d();
}

double truncated_double(const Rational& value) {
  const double nearest = to_double(value);
  if (!std::isfinite(nearest) || nearest == 0) {
    const Integer whole = value.get_num() / value.get_den();
    return nearest == 0 ? 0.0 : truncated_double(whole);
  }
  return value.get_d();
}

}  // namespace hottel
