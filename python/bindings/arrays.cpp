#include "python/bindings/arrays.h"

#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

#include "kernel/support/failure.h"
#include "python/bindings/errors.h"
#include "python/bindings/numbers.h"

namespace hottel::python {

void* take_array(std::size_t bytes) {
  constexpr std::size_t kLargePage = std::size_t{1} << 21;
  if (bytes < 2 * kLargePage) {
    if (void* const memory = std::malloc(std::max<std::size_t>(bytes, 1))) return memory;
    throw std::bad_alloc();
  }
  const std::size_t rounded = (bytes + kLargePage - 1) / kLargePage * kLargePage;
  void* const memory = rounded < bytes ? nullptr : std::aligned_alloc(kLargePage, rounded);
  if (memory == nullptr) throw std::bad_alloc();
  madvise(memory, rounded, MADV_HUGEPAGE);  // a wish: nothing depends on it
  return memory;
}

void give_array(void* memory) noexcept { std::free(memory); }

py::tuple tuple_of(const std::vector<std::string>& texts) {
  py::tuple result(texts.size());
  for (std::size_t k = 0; k < texts.size(); ++k) result[k] = py::str(texts[k]);
  return result;
}

namespace {

[[noreturn]] void refuse(const std::string& text) { throw InputError({std::string(kNoFile), 0}, text); }

// An array of doubles, n rows of so many numbers.
py::array_t<double> rows_of(const py::object& points, py::ssize_t width) {
  py::array array;
  try {
    array = py::module_::import("numpy").attr("asarray")(points);
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    refuse("points are n rows of " + std::to_string(width) + " numbers; these rows are not of one length");
  }
  if (array.ndim() == 1 && array.size() == 0) return py::array_t<double>(std::vector<py::ssize_t>{0, width});
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error("points are an array of real numbers, not of dtype " +
                         py::str(array.dtype()).cast<std::string>());
  if (array.ndim() != 2 || array.shape(1) != width)
    refuse("points have the shape (n, " + std::to_string(width) + "), not " +
           py::str(array.attr("shape")).cast<std::string>());
  if (kind == 'f' && array.itemsize() > 8) throw py::type_error("points are doubles: a longer float would be cut");
  return py::array_t<double, py::array::c_style | py::array::forcecast>(array);
}

}  // namespace

PythonPoints::PythonPoints(const py::object& array, std::size_t dimension, bool is_binary)
    : dimension_(dimension), is_binary_(is_binary) {
  const py::array_t<double> rows = rows_of(array, static_cast<py::ssize_t>(dimension));
  values_.assign(rows.data(), rows.data() + rows.size());
  for (std::size_t k = 0; k < values_.size(); ++k)
    if (!std::isfinite(values_[k]))
      refuse("point " + std::to_string(k / dimension) + " has a coordinate that is no finite number");
}

bool PythonPoints::is_origin(std::size_t k) const {
  for (std::size_t c = 0; c < dimension_; ++c)
    if (values_[k * dimension_ + c] != 0) return false;
  return true;
}

void PythonPoints::read(std::size_t k, std::size_t c, Rational& number) const {
  set_exact_number(values_[k * dimension_ + c], is_binary_, number);
}

void PythonPoints::read(std::size_t k, Point2& point) const {
  read(k, 0, point.x);
  read(k, 1, point.y);
}

void PythonPoints::read(std::size_t k, Point3& point) const {
  read(k, 0, point.x);
  read(k, 1, point.y);
  read(k, 2, point.z);
}

}  // namespace hottel::python
