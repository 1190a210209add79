#include "kernel/rational.h"

#include <charconv>

#include "kernel/nearest_double.h"

namespace hottel {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// An optional sign and at least one digit, nothing else.
bool is_integer(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  if (text.empty()) return false;
  for (char c : text)
    if (!is_digit(c)) return false;
  return true;
}

Integer integer(std::string_view text) {
  if (text[0] == '+') text.remove_prefix(1);
  return Integer(std::string(text), 10);
}

Integer power_of_ten(long exponent) {
  Integer result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return result;
}

// [sign] digits [. digits] [e [sign] digits], with at least one digit in the mantissa.
std::optional<Rational> parse_decimal(std::string_view text) {
  long exponent = 0;
  if (const auto e = text.find_first_of("eE"); e != std::string_view::npos) {
    std::string_view power = text.substr(e + 1);
    if (!is_integer(power)) return std::nullopt;
    if (power[0] == '+') power.remove_prefix(1);
    const auto [end, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (error != std::errc() || std::labs(exponent) > kMaxNumberExponent) return std::nullopt;
    text = text.substr(0, e);
  }
  std::string digits;
  long decimals = 0;
  bool point = false, any = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if ((c == '-' || c == '+') && i == 0) {
      if (c == '-') digits += c;
    } else if (c == '.' && !point) {
      point = true;
    } else if (is_digit(c)) {
      digits += c;
      any = true;
      decimals += point;
    } else {
      return std::nullopt;
    }
  }
  if (!any) return std::nullopt;
  exponent -= decimals;
  Rational value{integer(digits)};
  if (exponent >= 0)
    value *= Rational(power_of_ten(exponent));
  else
    value /= Rational(power_of_ten(-exponent));
  return value;
}

}  // namespace

std::optional<Rational> parse_rational(std::string_view text) {
  if (text.empty() || text.size() > kMaxNumberLength) return std::nullopt;
  if (const auto slash = text.find('/'); slash != std::string_view::npos) {
    const auto p = text.substr(0, slash), q = text.substr(slash + 1);
    if (!is_integer(p) || !is_integer(q)) return std::nullopt;
    const Integer denominator = integer(q);
    if (denominator == 0) return std::nullopt;
    Rational value(integer(p), denominator);
    value.canonicalize();
    return value;
  }
  return parse_decimal(text);
}

std::string to_string(const Rational& value) { return value.get_str(); }

double to_double(const Rational& value) { return nearest_double(value.get_num(), value.get_den()); }

Rational scaled_by_power_of_two(const Rational& value, long shift) {
  Rational result = value;
  if (shift > 0) mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<unsigned long>(shift));
  if (shift < 0) mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<unsigned long>(-shift));
  return result;
}

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end);
}

}  // namespace hottel
