#include "kernel/decimal.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "kernel/rounding.h"

namespace hottel {
namespace {

constexpr std::size_t kShortFraction = 11;  // characters of p/q

constexpr long kStep = 300;  // decimal places: within the range of doubles

double nearest_double(const RootSum& value) { return round_quotient(value, RootSum(Rational(1))).number.value; }

bool is_in_range(double nearest) { return nearest != 0 && std::isfinite(nearest); }

RootSum times_power_of_ten(const RootSum& value, long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
  return value * (exponent < 0 ? Rational(1, power) : Rational(power));
}

// A double as "1.25" and "-7".
struct Scientific {
  std::string mantissa;
  long exponent;

  explicit Scientific(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
    const std::string text(buffer, end);
    const std::size_t e = text.find('e');
    mantissa = text.substr(0, e);
    exponent = std::strtol(text.c_str() + e + 1, nullptr, 10);
  }
};

}  // namespace

std::string decimal_text(const RootSum& value) {
  const double nearest = nearest_double(value);
  if (value.is_zero() || is_in_range(nearest)) return shortest(nearest);
  const long step = nearest == 0 ? kStep : -kStep;
  long places = step;
  double scaled = nearest_double(times_power_of_ten(value, places));
  while (!is_in_range(scaled)) scaled = nearest_double(times_power_of_ten(value, places += step));
  places -= Scientific(scaled).exponent;  // now between 1 and 10, or rounded to 10
  const Scientific result(nearest_double(times_power_of_ten(value, places)));
  const long exponent = result.exponent - places;
  return result.mantissa + (exponent < 0 ? "e" : "e+") + std::to_string(exponent);
}

std::string decimal_text(const Rational& value) { return decimal_text(RootSum(value)); }

std::string short_text(const Rational& value) {
  std::string decimal = decimal_text(value);
  if (const auto read = parse_rational(decimal); read && *read == value) return decimal;
  std::string fraction = to_string(value);
  return fraction.size() <= kShortFraction ? fraction : decimal;
}

std::string length_text(const Rational& squared) {
  RootSum length;
  length.add(1, squared);
  return decimal_text(length);
}

}  // namespace hottel
