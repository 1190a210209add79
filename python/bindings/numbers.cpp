#include "python/bindings/numbers.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "python/bindings/errors.h"

namespace hottel::python {
namespace {

[[noreturn]] void refuse(const std::string& text) { throw InputError({std::string(kNoFile), 0}, text); }

// The shortest decimal of a double, as Python writes it. (shortest() writes all digits of large whole numbers.)
std::string decimal_text(double value) {
  constexpr double kAllWhole = 0x1p53;
  if (std::abs(value) < kAllWhole) return shortest(value);
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr};
}

std::string double_text(double value, bool is_binary, const std::string& place) {
  if (!std::isfinite(value)) refuse(place + " is not a number: " + shortest(value));
  return is_binary ? '"' + to_string(exact_value(value)) + '"' : decimal_text(value);
}

// The digits of an int.
std::string int_text(const py::handle& value, const std::string& place) {
  try {
    return py::str(value).cast<std::string>();
  } catch (const py::error_already_set& error) {  // Python itself refuses to write some thousand digits
    if (!error.matches(PyExc_ValueError)) throw;
    refuse(place + " has more digits than a number may have");
  }
}

bool is_instance(const py::handle& value, const char* module, const char* type) {
  return py::isinstance(value, py::module_::import(module).attr(type));
}

}  // namespace

namespace {

// The shortest decimal of a finite double as whole * 10^exponent.
struct Decimal {
  std::uint64_t whole = 0;  // without a sign
  int exponent = 0;
};
Decimal shortest_decimal(double value) {
  char text[32];
  const char* const end = std::to_chars(text, text + sizeof text, std::abs(value), std::chars_format::scientific).ptr;
  Decimal decimal;
  const char* at = text;
  int after_point = 0;
  for (bool is_after = false; *at != 'e'; ++at) {
    if (*at == '.') {
      is_after = true;
      continue;
    }
    decimal.whole = 10 * decimal.whole + static_cast<std::uint64_t>(*at - '0');  // at most 17 digits
    if (is_after) ++after_point;
  }
  std::from_chars(at[1] == '+' ? at + 2 : at + 1, end, decimal.exponent);
  decimal.exponent -= after_point;
  return decimal;
}

}  // namespace

void set_exact_number(double value, bool is_binary, Rational& result) {
  constexpr int kMost = 19;  // 10^19 is below 2^64
  const auto [whole, exponent] = is_binary || value == 0 ? Decimal{0, 1} : shortest_decimal(value);
  if (exponent > 0 || exponent < -kMost) {
    result = is_binary ? exact_value(value) : *parse_rational(decimal_text(value));
    return;
  }
  // In lowest terms: factors 2 and 5 of 10^-exponent that the whole number has too.
  std::uint64_t above = whole, below = 1;
  for (int k = 0; k < -exponent; ++k) below *= 10;
  const int twos = std::min(std::countr_zero(above), -exponent);
  above >>= twos;
  below >>= twos;
  for (int k = 0; k < -exponent && above % 5 == 0; ++k) {
    above /= 5;
    below /= 5;
  }
  static_assert(sizeof(unsigned long) == sizeof(std::uint64_t));
  mpz_set_ui(result.get_num_mpz_t(), above);
  mpz_set_ui(result.get_den_mpz_t(), below);
  if (value < 0) mpz_neg(result.get_num_mpz_t(), result.get_num_mpz_t());
}

std::optional<std::string> number_text(const py::handle& value, bool is_binary, const std::string& place) {
  if (py::isinstance<py::bool_>(value)) return std::nullopt;
  if (py::isinstance<py::int_>(value)) return int_text(value, place);
  if (PyFloat_Check(value.ptr())) return double_text(PyFloat_AsDouble(value.ptr()), is_binary, place);
  if (is_instance(value, "numpy", "number") && !is_instance(value, "numpy", "complexfloating"))
    return number_text(py::object(value.attr("item")()), is_binary, place);
  if (is_instance(value, "fractions", "Fraction"))
    return '"' + int_text(value.attr("numerator"), place) + '/' + int_text(value.attr("denominator"), place) + '"';
  if (is_instance(value, "decimal", "Decimal")) {
    if (!value.attr("is_finite")().cast<bool>()) refuse(place + " is not a number: " + int_text(value, place));
    return '"' + int_text(value, place) + '"';
  }
  return std::nullopt;
}

py::object int_of(const Integer& number) {
  return py::reinterpret_steal<py::object>(PyLong_FromString(number.get_str(16).c_str(), nullptr, 16));
}

py::object fraction_of(const Rational& number) {
  return py::module_::import("fractions").attr("Fraction")(int_of(number.get_num()), int_of(number.get_den()));
}

Rational rational_of(const py::handle& value, bool is_binary, const std::string& name) {
  std::string text;
  if (py::isinstance<py::str>(value)) {
    text = value.cast<std::string>();
  } else {
    const auto number = number_text(value, is_binary, name);
    if (!number)
      throw py::type_error(name + " is a number, not " +
                           py::str(py::type::handle_of(value).attr("__name__")).cast<std::string>());
    text = *number;
    std::erase(text, '"');
  }
  const auto result = parse_rational(text);
  if (!result) refuse(name + " is not a number that a scene file can hold: '" + text.substr(0, 40) + "'");
  return *result;
}

}  // namespace hottel::python
