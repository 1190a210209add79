#include "python/bindings/external_array.h"

#include <pybind11/numpy.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "kernel/support/failure.h"
#include "python/bindings/factors.h"

namespace hottel::python {
namespace {

[[noreturn]] void refuse_array(const std::string& text) { throw InputError({kArray, 0}, text); }

py::array array_of(const py::object& object) {
  try {
    return py::module_::import("numpy").attr("asarray")(object);
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    refuse_array("has rows that are not of one length");
  }
}

// Half of the last place of a dtype, relative; whole numbers are exact.
WrittenDigits digits_of(const py::dtype& dtype) {
  WrittenDigits digits;
  if (dtype.kind() == 'f')
    digits.relative = dtype.itemsize() == 4 ? 0x1p-24 : dtype.itemsize() == 2 ? 0x1p-11 : 0x1p-53;
  return digits;
}

void require_real(const py::dtype& dtype) {
  const char kind = dtype.kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error("this is an array of real numbers, not of dtype " +
                         py::str(static_cast<const py::object&>(dtype)).cast<std::string>());
  if (kind == 'f' && dtype.itemsize() > 8) throw py::type_error("numbers are doubles: a longer float would be cut");
}

std::vector<ExternalName> names_of(const py::object& names, std::uint32_t count, const char* what) {
  if (names.is_none()) return {};
  if (py::isinstance<py::str>(names)) throw py::type_error("names are a sequence of str");
  std::vector<ExternalName> result;
  for (const py::handle name : names) {
    if (!py::isinstance<py::str>(name)) throw py::type_error("names are a sequence of str");
    result.push_back({name.cast<std::string>(), 0});
  }
  if (result.size() != count)
    refuse_array("has " + std::to_string(count) + " " + what + ", and there are " + std::to_string(result.size()) +
                 " names");
  return result;
}

void add_entry(ExternalMatrix& matrix, std::uint32_t row, std::uint32_t column, double value) {
  if (!std::isfinite(value))
    refuse_array("has a number in row " + std::to_string(row) + ", column " + std::to_string(column) +
                 " that is not finite");
  if (value != 0) matrix.entries.push_back({row, column, 0, value});
}

std::uint32_t size_of(std::size_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max()) refuse_array("has more rows or columns than a scene has faces");
  return static_cast<std::uint32_t>(size);
}

ExternalMatrix dense(const py::object& object) {
  const ExternalArray array = external_array(object);
  if (array.shape.size() != 2)
    refuse_array("has " + std::to_string(array.shape.size()) + " dimensions, where a matrix has two");
  ExternalMatrix matrix;
  matrix.rows = size_of(array.shape[0]);
  matrix.columns = size_of(array.shape[1]);
  matrix.digits = array.digits;
  for (std::uint32_t i = 0; i < matrix.rows; ++i)
    for (std::uint32_t j = 0; j < matrix.columns; ++j)
      add_entry(matrix, i, j, array.values[std::size_t{i} * matrix.columns + j]);
  return matrix;
}

// Of whatever format: as rows whose columns ascend.
ExternalMatrix sparse_array(const py::object& object) {
  py::object rows = object.attr("tocsr")().attr("copy")();
  rows.attr("sum_duplicates")();
  require_real(rows.attr("dtype").cast<py::dtype>());
  const py::object places = rows.attr("tocoo")();
  using Places = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
  using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const auto row = places.attr("row").cast<Places>(), column = places.attr("col").cast<Places>();
  const auto values = places.attr("data").cast<Values>();
  const auto shape = object.attr("shape").cast<std::pair<std::size_t, std::size_t>>();
  ExternalMatrix matrix;
  matrix.rows = size_of(shape.first);
  matrix.columns = size_of(shape.second);
  matrix.digits = digits_of(rows.attr("dtype").cast<py::dtype>());
  for (py::ssize_t k = 0; k < values.size(); ++k)
    add_entry(matrix, static_cast<std::uint32_t>(row.at(k)), static_cast<std::uint32_t>(column.at(k)), values.at(k));
  return matrix;
}

ExternalMatrix of_factors(const PythonFactors& factors) {
  const ExchangeMatrix& own = factors.matrix();
  ExternalMatrix matrix;
  matrix.rows = matrix.columns = own.size() + 1;
  matrix.digits.relative = 0x1p-53;
  for (std::uint32_t i = 0; i <= own.sky(); ++i) matrix.row_names.push_back({own.name(i), 0});
  matrix.column_names = matrix.row_names;
  for (std::uint32_t i = 0; i < own.size(); ++i)
    for (const FactorEntry& entry : own.row(i)) add_entry(matrix, i, entry.to, entry.factor.value);
  return matrix;
}

bool has(const py::object& object, const char* name) { return py::hasattr(object, name); }

}  // namespace

ExternalArray external_array(const py::object& object) {
  const py::array array = array_of(object);
  require_real(array.dtype());
  ExternalArray result;
  result.digits = digits_of(array.dtype());
  for (py::ssize_t k = 0; k < array.ndim(); ++k) result.shape.push_back(static_cast<std::size_t>(array.shape(k)));
  const py::array_t<double, py::array::c_style | py::array::forcecast> doubles(array);
  result.values.assign(doubles.data(), doubles.data() + doubles.size());
  return result;
}

ExternalMatrix external_matrix(const py::object& object, const py::object& names) {
  const bool is_own = py::isinstance<PythonFactors>(object);
  const bool is_frame = has(object, "to_numpy") && has(object, "index") && has(object, "columns");
  ExternalMatrix matrix = is_own                 ? of_factors(object.cast<const PythonFactors&>())
                          : is_frame             ? dense(object.attr("to_numpy")())
                          : has(object, "tocsr") ? sparse_array(object)
                                                 : dense(object);
  matrix.file = matrix.names_file = kArray;
  if (is_frame && names.is_none()) {
    matrix.row_names = names_of(object.attr("index"), matrix.rows, "rows");
    matrix.column_names = names_of(object.attr("columns"), matrix.columns, "columns");
  } else if (!names.is_none()) {
    matrix.row_names = names_of(names, matrix.rows, "rows");
    matrix.column_names = names_of(names, matrix.columns, "columns");
  }
  return matrix;
}

}  // namespace hottel::python
