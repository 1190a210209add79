#include "io/results/short_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

template <class... Format>
std::string scientific(double value, Format... format) {
  std::array<char, 64> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, format...);
  return {text.data(), end.ptr};
}

std::size_t digits_in(std::string_view decimal) {
  const std::string_view mantissa = decimal.substr(0, decimal.find('e'));
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::size_t zeros = mantissa.size() - 1 - mantissa.find_last_not_of('0');
  return static_cast<std::size_t>(std::ranges::count_if(mantissa, is_digit)) - zeros;
}

// The shortest decimal; where that is a large whole number with digits that it does not need, with an exponent.
std::string shortest_digits(double value) {
  std::string plain = shortest(value), with_exponent = scientific(value);
  return digits_in(plain) > std::max<std::size_t>(digits_in(with_exponent), 1) && std::fabs(value) >= 1 ? with_exponent
                                                                                                        : plain;
}

// A decimal: 0.d1 d2 d3 ... times ten to the exponent, and its sign.
struct DecimalDigits {
  bool is_negative = false;
  std::string digits;
  int exponent = 0;

  // Of a text "-1.234e-05".
  explicit DecimalDigits(std::string_view scientific) {
    is_negative = scientific.front() == '-';
    const std::size_t e = scientific.find('e');
    for (const char c : scientific.substr(0, e))
      if (c >= '0' && c <= '9') digits += c;
    const char* first = scientific.data() + e + 1 + (scientific[e + 1] == '+' ? 1 : 0);
    std::from_chars(first, scientific.data() + scientific.size(), exponent);
    ++exponent;
  }

  // Cuts it off, toward 0, or takes the next decimal away from 0. REQUIRES more digits.
  void cut(std::size_t count, bool away) {
    digits.resize(count);
    if (!away) return;
    for (std::size_t k = count; k-- > 0;) {
      if (digits[k] != '9') {
        ++digits[k];
        return;
      }
      digits[k] = '0';
    }
    digits.insert(0, 1, '1');
    ++exponent;
  }

  // As std::to_chars writes a double: the shorter of both notations.
  std::string text() const {
    const std::optional<double> value = magnitude();
    std::string result = value ? shortest_digits(*value) : "inf";
    return is_negative ? "-" + result : result;
  }
  bool is_beyond_doubles() const { return !magnitude(); }

 private:
  // Nothing where that is beyond doubles.
  std::optional<double> magnitude() const {
    std::string shown = digits;
    shown.erase(shown.find_last_not_of('0') + 1);
    const std::string scientific = "0." + shown + "e" + std::to_string(exponent);
    double value = 0;
    const auto read = std::from_chars(scientific.data(), scientific.data() + scientific.size(), value);
    if (read.ec == std::errc::result_out_of_range && exponent > 0) return std::nullopt;
    return value;
  }
};

}  // namespace

std::string short_digits(double value, std::optional<int> digits, RoundedTo to) {
  if (!digits) return shortest(value);
  HOTTEL_REQUIRE(1 <= *digits && *digits <= kMostDigits);
  if (!std::isfinite(value)) return shortest(value);
  const auto count = static_cast<std::size_t>(*digits);
  DecimalDigits decimal(scientific(value));
  if (decimal.digits.size() <= count) return shortest_digits(value);
  if (to != RoundedTo::kNearest) {
    decimal.cut(count, (to == RoundedTo::kAbove) != decimal.is_negative);
    return decimal.text();
  }
  const DecimalDigits nearest(scientific(value, *digits - 1));
  if (!nearest.is_beyond_doubles()) return nearest.text();
  decimal.cut(count, false);
  return decimal.text();
}

std::string short_visibility(double value, std::optional<int> digits) {
  std::string text = short_digits(value, digits);
  return value < 1 && text == "1" ? short_digits(value, digits, RoundedTo::kBelow) : text;
}

}  // namespace hottel
