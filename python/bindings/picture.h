// Pictures as Python holds them.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "python/bindings/arrays.h"
#include "python/bindings/scene.h"
#include "python/bindings/waiting.h"
#include "viewer/picture/picture_options.h"

namespace hottel::python {

// A picture that can be had in every format. REQUIRES the lock of the interpreter for every function.
class PythonPicture {
 public:
  // Returns the bytes of a file. REQUIRES nothing of Python.
  using Draw = std::function<std::string(PictureFormat)>;

  // Draws the pixels at once, so that what cannot be drawn is told here.
  PythonPicture(Draw draw, const Waiting& waiting);

  py::bytes file(const std::string& format) const;
  // Red, green and blue, of shape (height, width, 3), the upper row first.
  const py::array& pixels() const { return pixels_; }
  // Writes a file of the format that its ending says.
  void save(const std::string& path) const;

 private:
  const std::string& drawn(PictureFormat format) const;

  Draw draw_;
  mutable std::map<PictureFormat, std::string> files_;
  py::array pixels_;
};

// Throws UsageError for a width of a picture that is none; 0 stands for the usual one.
std::uint32_t width_of_picture(std::int64_t size);

// A scene by itself: in the plane its plan, in space what its camera sees before any light is computed.
PythonPicture scene_picture(const PythonScene& scene, std::int64_t size, bool has_axes);

}  // namespace hottel::python
