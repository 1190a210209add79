// Visibility polygons as Python holds them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/polygons_of_points.h"
#include "kernel/support/stage.h"
#include "python/bindings/arrays.h"

namespace hottel::python {

// What points see, as lists: two numbers a corner, the first corner of each point and the end, what is seen after each
// corner as a place in names. REQUIRES nothing of Python.
struct VisibleLists {
  UnsetVector<double> xy;
  std::vector<std::int64_t> begin{0};
  UnsetVector<std::int32_t> face;
  std::vector<std::string> names;  // in the order in which they are first seen
};
// Those of visibility_polygons(), without the memory of one list a point. Throws what progress throws.
VisibleLists visible_lists(const PreparedScene2& prepared, const PythonPoints& points, const PolygonsOptions2& wanted,
                           const StageProgress& progress);

// The same as arrays: those of the .npz file of `hottel visibility --points`.
struct PythonVisible {
  py::array xy, begin, face;
  std::vector<std::string> names;

  explicit PythonVisible(VisibleLists lists);
};

}  // namespace hottel::python
