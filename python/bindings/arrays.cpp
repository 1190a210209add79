#include "python/bindings/arrays.h"

#include <cmath>

#include "kernel/support/failure.h"
#include "python/bindings/errors.h"
#include "python/bindings/numbers.h"
#include "python/bindings/waiting.h"

namespace hottel::python {

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

// Exact points of rows of doubles; a million take a second, so that others run meanwhile.
template <class Make>
auto points_of(const py::object& points, py::ssize_t width, const Make& make) {
  const py::array_t<double> rows = rows_of(points, width);
  const auto at = rows.unchecked<2>();
  std::vector<decltype(make(at, 0))> result;
  return without_lock({}, [&](const StageProgress& progress) {
    result.reserve(static_cast<std::size_t>(at.shape(0)));
    for (py::ssize_t k = 0; k < at.shape(0); ++k) {
      for (py::ssize_t c = 0; c < width; ++c)
        if (!std::isfinite(at(k, c)))
          refuse("point " + std::to_string(k) + " has a coordinate that is no finite number");
      result.push_back(make(at, k));
      if (k % 1024 == 0) progress("points", static_cast<double>(k) / static_cast<double>(at.shape(0)));
    }
    return std::move(result);
  });
}

}  // namespace

std::vector<Point2> points_2(const py::object& array, bool is_binary) {
  return points_of(array, 2, [is_binary](const auto& at, py::ssize_t k) {
    return Point2{exact_number(at(k, 0), is_binary), exact_number(at(k, 1), is_binary)};
  });
}

std::vector<Point3> points_3(const py::object& array, bool is_binary) {
  return points_of(array, 3, [is_binary](const auto& at, py::ssize_t k) {
    return Point3{exact_number(at(k, 0), is_binary), exact_number(at(k, 1), is_binary),
                  exact_number(at(k, 2), is_binary)};
  });
}

}  // namespace hottel::python
