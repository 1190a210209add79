// Arrays of NumPy that nobody can change, and arrays that come from outside.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/point.h"
#include "geometry/space/point.h"

namespace hottel::python {

namespace py = pybind11;

// Memory for large arrays, in large pages where the system has them, as NumPy takes it: small ones cost more than it
// does to fill them. Throws std::bad_alloc.
void* take_array(std::size_t bytes);
void give_array(void* memory) noexcept;

// Leaves what a vector is resized to without a value, for those who then set all of it, on many threads.
template <class T>
struct Unset : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = Unset<Other>;
  };
  T* allocate(std::size_t count) { return static_cast<T*>(take_array(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t) noexcept { give_array(memory); }
  template <class... Arguments>
  void construct(T* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0)
      ::new (static_cast<void*>(place)) T;
    else
      ::new (static_cast<void*>(place)) T(std::forward<Arguments>(arguments)...);
  }
};
template <class T>
using UnsetVector = std::vector<T, Unset<T>>;

// Returns an array that owns the values and can never be made writable: its base gives nobody a buffer to write to.
// REQUIRES as many values as the shape says.
template <class T, class Allocator>
py::array frozen(std::vector<T, Allocator> values, std::vector<py::ssize_t> shape) {
  using Values = std::vector<T, Allocator>;
  values.reserve(1);  // without an address NumPy would take memory of its own
  auto owned = std::make_unique<Values>(std::move(values));
  const T* const data = owned->data();
  const py::capsule base(owned.release(), [](void* pointer) { delete static_cast<Values*>(pointer); });
  py::array_t<T> array(std::move(shape), data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}
template <class T, class Allocator>
py::array frozen(std::vector<T, Allocator> values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return frozen(std::move(values), {size});
}

// Returns the values themselves as an array, which nobody can change and which keeps their owner. REQUIRES that they
// stay as they are as long as the owner lives.
template <class T>
py::array shared(std::span<const T> values, std::shared_ptr<const void> owner) {
  if (values.empty()) return frozen(std::vector<T>());
  using Owner = std::shared_ptr<const void>;
  const py::capsule base(new Owner(std::move(owner)), [](void* pointer) { delete static_cast<Owner*>(pointer); });
  py::array_t<T> array(static_cast<py::ssize_t>(values.size()), values.data(), base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::tuple tuple_of(const std::vector<std::string>& texts);

// Points that came from outside: doubles that are kept, and made exact when they are asked for.
class PythonPoints {
 public:
  // Of an array-like of n rows of so many numbers; an empty list has no points. A float is its shortest decimal as in
  // scene files, or with is_binary the double that it is. Throws TypeError for what is no array of real numbers,
  // InputError for another shape and for what is not finite, naming the point.
  PythonPoints(const py::object& array, std::size_t dimension, bool is_binary);

  std::size_t size() const { return values_.size() / dimension_; }
  // REQUIRES that dimension, and k < size().
  Point2 in_plane(std::size_t k) const {
    Point2 point;
    read(k, point);
    return point;
  }
  Point3 in_space(std::size_t k) const {
    Point3 point;
    read(k, point);
    return point;
  }
  // The same into a point that is there, whose memory is used again.
  void read(std::size_t k, Point2& point) const;
  void read(std::size_t k, Point3& point) const;
  // Whether all its numbers are 0. REQUIRES k < size().
  bool is_origin(std::size_t k) const;

 private:
  void read(std::size_t k, std::size_t c, Rational& number) const;

  std::size_t dimension_;
  bool is_binary_;
  std::vector<double> values_;
};

}  // namespace hottel::python
