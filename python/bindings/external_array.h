// Results of other programs, given as arrays of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "io/external/external_file.h"

namespace hottel::python {

namespace py = pybind11;

// What arrays are called in messages that come from no file.
inline constexpr const char* kArray = "array";

// An array of real numbers, and how finely they are held.
struct ExternalArray {
  std::vector<double> values;  // in C order
  std::vector<std::size_t> shape;
  WrittenDigits digits;
};

// Throws TypeError for what is no array of real numbers, InputError for rows that are not of one length.
ExternalArray external_array(const py::object& object);

// Returns a matrix of view factors: a dense array, a sparse matrix of SciPy, a data frame of pandas, or Factors; as
// read_external_matrix reads it from a NumPy file. names: of rows and columns, or None: those that the object has.
// Throws TypeError and InputError as external_array() does, for what has other than two dimensions, for numbers that
// are not finite, and unless there is a name for each.
ExternalMatrix external_matrix(const py::object& object, const py::object& names);

}  // namespace hottel::python
