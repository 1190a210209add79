#include "kernel/determinant.h"

namespace hottel {
namespace {

// Sets result to a b - c d.
void set_minor(Integer& result, const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  mpz_mul(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  mpz_submul(result.get_mpz_t(), c.get_mpz_t(), d.get_mpz_t());
}

double scaled(const Integer& value, long shift) {
  long exponent;
  const double mantissa = mpz_get_d_2exp(&exponent, value.get_mpz_t());
  return mantissa == 0 ? 0 : std::ldexp(mantissa, static_cast<int>(std::max(exponent - shift, -2000L)));
}

}  // namespace

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  IntegerVector c;
  set_minor(c.x, a.y, b.z, a.z, b.y);
  set_minor(c.y, a.z, b.x, a.x, b.z);
  set_minor(c.z, a.x, b.y, a.y, b.x);
  return c;
}

Integer dot(const IntegerVector& a, const IntegerVector& b) {
  Integer sum = a.x * b.x;
  mpz_addmul(sum.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
  mpz_addmul(sum.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
  return sum;
}

IntegerVector difference(const IntegerVector& a, const IntegerVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

bool is_zero(const IntegerVector& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

IntegerVector primitive(const IntegerVector& a) {
  if (is_zero(a)) return a;
  const Integer factor = gcd(gcd(a.x, a.y), a.z);
  return {a.x / factor, a.y / factor, a.z / factor};
}

long bits(const IntegerVector& a) {
  const auto of_one = [](const Integer& value) {
    return value == 0 ? 0L : static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
  };
  return std::max({of_one(a.x), of_one(a.y), of_one(a.z)});
}

int determinant_sign(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c) {
  return sgn(dot(cross(a, b), c));
}

BoundedVector rounded(const IntegerVector& a, long shift) {
  BoundedVector result{scaled(a.x, shift), scaled(a.y, shift), scaled(a.z, shift)};
  result.size = std::max({std::fabs(result.x), std::fabs(result.y), std::fabs(result.z)});
  if (shift != 0 || bits(a) > 53) result.error = 0x1p-52 * result.size + detail::kUnderflow;
  return result;
}

}  // namespace hottel
