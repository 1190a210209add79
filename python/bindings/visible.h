// Visibility polygons as Python holds them.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/visibility/rounded_polygon.h"
#include "python/bindings/arrays.h"

namespace hottel::python {

// What points see: the arrays of the .npz file of `hottel visibility --points`.
struct PythonVisible {
  py::array xy, begin, face;  // corners, the first corner of each point, what is seen after each corner
  std::vector<std::string> names;
};

PythonVisible visible_arrays(const PreparedScene2& prepared, const std::vector<RoundedPolygon2>& polygons);

}  // namespace hottel::python
