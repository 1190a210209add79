#include "io/scene/exact_decimal.h"

#include <algorithm>
#include <cstdlib>

namespace hottel {
namespace {

// The most zeros that are written instead of an exponent.
constexpr long kMostZeros = 24;

}  // namespace

std::optional<Decimal> exact_decimal(const Rational& value) {
  if (value == 0) return Decimal{0, 0};
  const Integer two = 2, five = 5, ten = 10;
  Integer rest;
  const auto twos = mpz_remove(rest.get_mpz_t(), value.get_den_mpz_t(), two.get_mpz_t());
  const auto fives = mpz_remove(rest.get_mpz_t(), rest.get_mpz_t(), five.get_mpz_t());
  if (rest != 1) return std::nullopt;
  Decimal result{value.get_num(), -static_cast<long>(std::max(twos, fives))};
  if (twos != fives) {
    mpz_pow_ui(rest.get_mpz_t(), (twos < fives ? two : five).get_mpz_t(),
               std::max(twos, fives) - std::min(twos, fives));
    result.digits *= rest;
  }
  if (result.exponent == 0)
    result.exponent =
        static_cast<long>(mpz_remove(result.digits.get_mpz_t(), result.digits.get_mpz_t(), ten.get_mpz_t()));
  return result;
}

std::optional<std::string> exact_decimal_text(const Rational& value) {
  const auto decimal = exact_decimal(value);
  if (!decimal || std::labs(decimal->exponent) > kMaxNumberExponent) return std::nullopt;
  std::string text = Integer(abs(decimal->digits)).get_str();
  const long exponent = decimal->exponent, digits = static_cast<long>(text.size());
  if (exponent > kMostZeros || -exponent > digits + kMostZeros) {
    text += "e" + std::to_string(exponent);
  } else if (exponent >= 0) {
    text.append(static_cast<std::size_t>(exponent), '0');
  } else {
    if (digits <= -exponent) text.insert(0, static_cast<std::size_t>(1 - exponent - digits), '0');
    text.insert(text.size() - static_cast<std::size_t>(-exponent), 1, '.');
  }
  if (sgn(decimal->digits) < 0) text.insert(0, 1, '-');
  if (text.size() > kMaxNumberLength) return std::nullopt;
  return text;
}

}  // namespace hottel
