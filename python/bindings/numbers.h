// Numbers of Python as exact numbers.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "kernel/rational.h"

namespace hottel::python {

namespace py = pybind11;

// Sets a number to what a finite double means: its shortest decimal, as in scene files, or with is_binary the double
// itself.
void set_exact_number(double value, bool is_binary, Rational& result);

// Returns how a scene file holds a number of Python: "3", "0.1", "\"1/3\""; nothing for what is none. int, float, str
// of a number is none here; fractions.Fraction, decimal.Decimal, and NumPy's numbers are. place: of it, for messages.
// Throws InputError where it is infinite, no number, or longer than a file may hold.
std::optional<std::string> number_text(const py::handle& value, bool is_binary, const std::string& place);

// Returns an int, and a fractions.Fraction.
py::object int_of(const Integer& number);
py::object fraction_of(const Rational& number);

// Returns the exact value of a number of Python, or of a text as scene files have them. Throws InputError as
// number_text does and for other texts, TypeError for other objects, both naming it.
Rational rational_of(const py::handle& value, bool is_binary, const std::string& name);

}  // namespace hottel::python
