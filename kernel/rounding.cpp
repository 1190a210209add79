#include "kernel/rounding.h"

#include <cmath>

#include "kernel/ball.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

RoundedByTier round_rational(const Rational& value, Tier tier) {
  const double nearest = to_double(value);
  const int side = std::isfinite(nearest) ? cmp(value, exact_value(nearest)) : -sgn(value);
  return {{nearest, static_cast<signed char>(side > 0 ? 1 : side < 0 ? -1 : 0)}, tier};
}

// The number half-way between two neighbouring doubles, where infinity stands for the power of two it begins at.
Rational half_way(double below, double above) {
  const Rational beyond(Integer(1) << 1024);
  const Rational low = std::isinf(below) ? Rational(-beyond) : exact_value(below);
  const Rational high = std::isinf(above) ? beyond : exact_value(above);
  return (low + high) / 2;
}

// The quotient where it is rational because both are multiples of the same root.
std::optional<Rational> rational_quotient(const RootSum& numerator, const RootSum& denominator) {
  if (numerator.terms().size() != 1 || denominator.terms().size() != 1) return std::nullopt;
  const RootSum::Term &n = numerator.terms().front(), &d = denominator.terms().front();
  const Integer product = n.radicand * d.radicand;
  if (!mpz_perfect_square_p(product.get_mpz_t())) return std::nullopt;
  return Rational(n.coefficient * Rational(Integer(sqrt(product))) / (d.coefficient * d.radicand));
}

// True iff value * denominator == numerator.
bool equals(const RootSum& numerator, const RootSum& denominator, const Rational& value) {
  return (numerator - denominator * value).is_zero();
}

}  // namespace

FixedDivisor::FixedDivisor(const FixedSum& sum) : number_(sum) {
  if (number_.may_be_zero()) return;
  inverse_ = 1 / number_.value_.hi;
  relative_error_ = sum.error / number_.value_.hi;
}

std::optional<RoundedByTier> round_quotient(const FixedDividend& numerator, const FixedDivisor& denominator) {
  const FixedSum &top = numerator.sum_, &bottom = denominator.number_.sum_;
  if (top.error == 0 && top.value == 0) return RoundedByTier{{0.0, 0}, Tier::kDouble};
  if (top.error == 0 && bottom.error == 0) {
    Rational quotient(to_integer(top.value), to_integer(bottom.value));
    quotient.canonicalize();
    return round_rational(quotient, Tier::kDouble);
  }
  const DoubleDouble &n = numerator.value_, &d = denominator.number_.value_;
  if (std::fabs(n.hi) <= 2 * top.error) return std::nullopt;
  // Off by less than 2^-51 |q|, as q is a product of two rounded factors and both low parts are still left out.
  const double q = n.hi * denominator.inverse_;
  double p, e;
  two_product(q, d.hi, p, e);
  const double correction = (((n.hi - p) - e) + (n.lo - q * d.lo)) * denominator.inverse_;
  const double hi = q + correction;
  const double lo = (q - hi) + correction;
  // The five roundings of the correction and both conversions come to less than 2^-100 |q|; the last factor covers the
  // rounding of this bound and the second-order terms of the two relative errors.
  const double error =
      2.0 * (std::fabs(q) * (0x1p-100 + denominator.relative_error_) + top.error * denominator.inverse_);
  const double below = lo - error, above = lo + error;
  if (hi + below != hi || hi + above != hi) return std::nullopt;
  // Either side is as likely: no branch is taken on it.
  const int side = (below > 0) - (above < 0);
  if (side == 0) return std::nullopt;
  return RoundedByTier{{hi, static_cast<signed char>(side)}, Tier::kDoubleDouble};
}

FixedScale::FixedScale(const Rational& unit) {
  HOTTEL_REQUIRE(unit > 0);
  const long bits = static_cast<long>(mpz_sizeinbase(unit.get_den_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(unit.get_num_mpz_t(), 2));
  exponent_ = 99 - bits;
  Integer numerator = unit.get_den(), denominator = unit.get_num(), quotient, remainder;
  if (exponent_ >= 0)
    numerator <<= static_cast<unsigned long>(exponent_);
  else
    denominator <<= static_cast<unsigned long>(-exponent_);
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const Integer high = quotient >> 64, low = quotient - (high << 64);
  divisor_ = FixedDivisor({(static_cast<Int128>(high.get_ui()) << 64) + low.get_ui(), remainder == 0 ? 0.0 : 1.0});
}

std::optional<RoundedByTier> round_scaled(const FixedDividend& sum, const FixedScale& scale) {
  auto result = round_quotient(sum, scale.divisor_);
  if (!result) return std::nullopt;
  int exponent;
  std::frexp(result->number.value, &exponent);
  if (exponent + scale.exponent_ < -1000 || exponent + scale.exponent_ > 1000) return std::nullopt;
  result->number.value = std::ldexp(result->number.value, static_cast<int>(scale.exponent_));
  return result;
}

RoundedByTier round_quotient(const RootSum& numerator, const RootSum& denominator) {
  HOTTEL_REQUIRE(!denominator.is_zero());
  if (numerator.is_zero()) return {{0.0, 0}, Tier::kDouble};
  if (const auto quotient = rational_quotient(numerator, denominator)) return round_rational(*quotient, Tier::kRootSum);
  bool is_known_not_to_be_a_tie = false;
  for (long precision = 128;; precision *= 2) {
    const Ball bottom = denominator.ball(precision);
    if (bottom.sign() == 0) continue;
    const Ball quotient = numerator.ball(precision).over(bottom, precision);
    const Enclosure nearest = quotient.nearest_of_ends();
    if (std::isinf(nearest.lower) && nearest.lower == nearest.upper)
      return {{nearest.lower, static_cast<signed char>(nearest.lower > 0 ? -1 : 1)}, Tier::kBall};
    if (nearest.lower == nearest.upper) {
      if (const int side = quotient.compare(nearest.lower); side != 0)
        return {{nearest.lower, static_cast<signed char>(side)}, Tier::kBall};
    }
    if (is_known_not_to_be_a_tie || precision < 256) continue;
    // The quotient may be a double itself, or lie half-way between two: only the canonical sum can tell.
    if (nearest.lower == nearest.upper) {
      if (equals(numerator, denominator, exact_value(nearest.lower))) return {{nearest.lower, 0}, Tier::kRootSum};
      is_known_not_to_be_a_tie = true;
    } else if (std::nextafter(nearest.lower, nearest.upper) == nearest.upper) {
      const Rational tie = half_way(nearest.lower, nearest.upper);
      if (equals(numerator, denominator, tie)) return round_rational(tie, Tier::kRootSum);
      is_known_not_to_be_a_tie = true;
    }
  }
}

}  // namespace hottel
