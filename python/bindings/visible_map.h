// What points of space see, as Python holds it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/stage.h"
#include "python/bindings/arrays.h"

namespace hottel::python {

// What points see, as lists: the shares of each point, and the pieces of each, with their corners. NaN of the sky for
// points in solids. REQUIRES nothing of Python.
struct MapLists {
  std::vector<std::int64_t> begin{0}, piece_begin{0}, corner_begin{0};  // of points; of points; of pieces
  std::vector<std::int32_t> face, piece_face;                           // places in names
  std::vector<double> fraction, sky, directions, xyz;
  std::vector<std::string> names;
};
MapLists map_lists(const PreparedScene3& prepared, const PythonPoints& points, const StageProgress& progress);

struct PythonVisibleMap {
  py::array begin, face, fraction, sky, piece_begin, piece_face, corner_begin, directions, xyz;
  std::vector<std::string> names;

  explicit PythonVisibleMap(MapLists lists);
};

}  // namespace hottel::python
