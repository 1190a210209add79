#include "kernel/determinant.h"

#include <cstdlib>
#include <limits>

namespace hottel {
namespace {

// Sets result to a b - c d.
void set_minor(Integer& result, const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  mpz_mul(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  mpz_submul(result.get_mpz_t(), c.get_mpz_t(), d.get_mpz_t());
}

// Where a double holds a whole number: sets it, without asking GMP.
bool set_short(double& result, const Integer& value) {
  if (mpz_size(value.get_mpz_t()) > 1) return false;
  const mp_limb_t size = mpz_getlimbn(value.get_mpz_t(), 0);
  if (size >> std::numeric_limits<double>::digits != 0) return false;
  result = sgn(value) < 0 ? -static_cast<double>(size) : static_cast<double>(size);
  return true;
}

// Powers of two within this are far from what rounds numbers that doubles hold.
constexpr long kMostShort = 900;

double halved(double value, long shift) { return shift == 0 ? value : std::ldexp(value, static_cast<int>(-shift)); }

double scaled(const Integer& value, long shift) {
  if (double number; std::abs(shift) <= kMostShort && set_short(number, value)) return halved(number, shift);
  long exponent;
  const double mantissa = mpz_get_d_2exp(&exponent, value.get_mpz_t());
  return mantissa == 0 ? 0 : std::ldexp(mantissa, static_cast<int>(std::max(exponent - shift, -2000L)));
}

}  // namespace

void set_cross(IntegerVector& result, const IntegerVector& a, const IntegerVector& b) {
  set_minor(result.x, a.y, b.z, a.z, b.y);
  set_minor(result.y, a.z, b.x, a.x, b.z);
  set_minor(result.z, a.x, b.y, a.y, b.x);
}

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  IntegerVector c;
  set_cross(c, a, b);
  return c;
}

Integer dot(const IntegerVector& a, const IntegerVector& b) {
  Integer sum = a.x * b.x;
  mpz_addmul(sum.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
  mpz_addmul(sum.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
  return sum;
}

IntegerVector difference(const IntegerVector& a, const IntegerVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

IntegerVector sum(const IntegerVector& a, const IntegerVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

IntegerVector opposite(const IntegerVector& a) { return {-a.x, -a.y, -a.z}; }

IntegerVector multiple(const Integer& factor, const IntegerVector& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}

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

int dot_sign(const IntegerVector& a, const IntegerVector& b) {
  thread_local Integer sum;
  mpz_mul(sum.get_mpz_t(), a.x.get_mpz_t(), b.x.get_mpz_t());
  mpz_addmul(sum.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
  mpz_addmul(sum.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
  return sgn(sum);
}

int determinant_sign(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c) {
  thread_local IntegerVector product;
  set_cross(product, a, b);
  return dot_sign(product, c);
}

Int128 small_determinant(const BoundedVector& a, const BoundedVector& b, const BoundedVector& c) {
  const auto whole = [](double value) { return static_cast<Int128>(static_cast<std::int64_t>(value)); };
  const Int128 ax = whole(a.x), ay = whole(a.y), az = whole(a.z), bx = whole(b.x), by = whole(b.y), bz = whole(b.z);
  return (ay * bz - az * by) * whole(c.x) + (az * bx - ax * bz) * whole(c.y) + (ax * by - ay * bx) * whole(c.z);
}

BoundedVector rounded(const IntegerVector& a, long shift) {
  BoundedVector result{scaled(a.x, shift), scaled(a.y, shift), scaled(a.z, shift)};
  result.size = std::max({std::fabs(result.x), std::fabs(result.y), std::fabs(result.z)});
  if (shift != 0 || bits(a) > 53) result.error = 0x1p-52 * result.size + detail::kUnderflow;
  return result;
}

double rounded_quotient(const Integer& a, const Integer& b, long shift) {
  double numerator, denominator;
  if (std::abs(shift) <= kMostShort && set_short(numerator, a) && set_short(denominator, b))
    return halved(numerator / denominator, shift);
  long of_a, of_b;
  const double top = mpz_get_d_2exp(&of_a, a.get_mpz_t()), bottom = mpz_get_d_2exp(&of_b, b.get_mpz_t());
  return top == 0 ? 0 : std::ldexp(top / bottom, static_cast<int>(std::clamp(of_a - of_b - shift, -2000L, 2000L)));
}

}  // namespace hottel
