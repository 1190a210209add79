// Arrays of NumPy that nobody can change, and arrays that come from outside.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/point.h"
#include "geometry/space/point.h"

namespace hottel::python {

namespace py = pybind11;

// Returns an array that owns the values and can never be made writable: its base gives nobody a buffer to write to.
// REQUIRES as many values as the shape says.
template <class T>
py::array frozen(std::vector<T> values, std::vector<py::ssize_t> shape) {
  values.reserve(1);  // without an address NumPy would take memory of its own
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  const T* const data = owned->data();
  const py::capsule base(owned.release(), [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
  py::array_t<T> array(std::move(shape), data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}
template <class T>
py::array frozen(std::vector<T> values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return frozen(std::move(values), {size});
}

py::tuple tuple_of(const std::vector<std::string>& texts);

// Returns the points of an array-like of n rows of 2 or 3 numbers; an empty list has no points. A float is its
// shortest decimal as in scene files, or with is_binary the double that it is. Throws TypeError for what is no array of
// real numbers, InputError for another shape and for what is not finite, naming the point.
std::vector<Point2> points_2(const py::object& array, bool is_binary);
std::vector<Point3> points_3(const py::object& array, bool is_binary);

}  // namespace hottel::python
