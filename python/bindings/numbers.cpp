#include "python/bindings/numbers.h"

#include <cmath>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "python/bindings/errors.h"

namespace hottel::python {
namespace {

[[noreturn]] void refuse(const std::string& text) { throw InputError({std::string(kNoFile), 0}, text); }

std::string double_text(double value, bool is_binary, const std::string& place) {
  if (!std::isfinite(value)) refuse(place + " is not a number: " + shortest(value));
  return is_binary ? '"' + to_string(exact_value(value)) + '"' : shortest(value);
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

Rational exact_number(double value, bool is_binary) {
  return is_binary ? exact_value(value) : *parse_rational(shortest(value));
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
