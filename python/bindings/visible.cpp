#include "python/bindings/visible.h"

#include <map>
#include <unordered_map>
#include <utility>

#include "geometry/plane/visibility/polygons_of_points.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"

namespace hottel::python {

VisibleLists visible_lists(const PreparedScene2& prepared, const std::vector<RoundedPolygon2>& polygons) {
  VisibleLists lists;
  std::map<std::string, std::int32_t> place_of_name;
  std::unordered_map<std::int64_t, std::int32_t> place_of_side;
  const auto place_of = [&](PieceSideId side) {
    const auto known = place_of_side.find(side.number());
    if (known != place_of_side.end()) return known->second;
    const std::string name = polygon_side_name(prepared, side);
    const auto [place, is_new] = place_of_name.emplace(name, static_cast<std::int32_t>(lists.names.size()));
    if (is_new) lists.names.push_back(name);
    place_of_side.emplace(side.number(), place->second);
    return place->second;
  };
  for (const RoundedPolygon2& polygon : polygons) {
    for (const RoundedPolygon2::Corner& corner : polygon.corners) {
      lists.xy.insert(lists.xy.end(), {corner.x, corner.y});
      lists.face.push_back(place_of(corner.after));
    }
    lists.begin.push_back(static_cast<std::int64_t>(lists.face.size()));
  }
  return lists;
}

PythonVisible::PythonVisible(VisibleLists lists) : names(std::move(lists.names)) {
  const auto corners = static_cast<py::ssize_t>(lists.face.size());
  xy = frozen(std::move(lists.xy), {corners, 2});
  begin = frozen(std::move(lists.begin));
  face = frozen(std::move(lists.face));
}

namespace {

std::size_t count(const PythonVisible& visible) { return static_cast<std::size_t>(visible.begin.size()) - 1; }

// The corners of one point, as a slice of an array by corner.
py::slice corners_of(const PythonVisible& visible, py::ssize_t point) {
  const auto points = static_cast<py::ssize_t>(count(visible));
  if (point < -points || point >= points)
    throw py::index_error("there are " + std::to_string(points) + " points, and none is number " +
                          std::to_string(point));
  const auto* const begin = static_cast<const std::int64_t*>(visible.begin.data());
  const py::ssize_t k = point < 0 ? point + points : point;
  return {static_cast<py::ssize_t>(begin[k]), static_cast<py::ssize_t>(begin[k + 1]), 1};
}

py::array polygon(const PythonVisible& visible, py::ssize_t point) { return visible.xy[corners_of(visible, point)]; }

py::tuple sides(const PythonVisible& visible, py::ssize_t point) {
  std::vector<std::string> names;
  for (const py::handle place : py::object(visible.face[corners_of(visible, point)]))
    names.push_back(visible.names[place.cast<std::size_t>()]);
  return tuple_of(names);
}

}  // namespace

void add_visible(py::module_& module) {
  py::class_<PythonVisible> type(
      module, "Visible",
      "What n points of the plane see: visible[k] is the visibility polygon of point k, float64 of shape (corners, "
      "2),\n"
      "counter-clockwise, each coordinate the nearest double. IndexError for a point that there is not.");
  type.def_readonly("xy", &PythonVisible::xy,
                    "Corners of all points, float64 of shape (corners, 2), in units of the scene. Read only.")
      .def_readonly("begin", &PythonVisible::begin,
                    "int64 of shape (n + 1,): the corners of point k are begin[k] up to begin[k + 1]. Read only.")
      .def_readonly("face", &PythonVisible::face,
                    "int32 of shape (corners,): what is seen from each corner to the next, as a place in names.\n"
                    "Read only.")
      .def_property_readonly(
          "names", [](const PythonVisible& visible) { return tuple_of(visible.names); },
          "What is seen, a tuple of str: names of faces, 'sky', '#range' along arcs, '' along a ray.")
      .def("sides", &sides, py::arg("point"),
           "Returns the names of what is seen after each corner of one point, a tuple of str. IndexError for a point\n"
           "that there is not.")
      .def("__getitem__", &polygon, py::arg("point"))
      .def("__len__", &count)
      .def("__repr__", [](const PythonVisible& visible) {
        return "<hottel.Visible from " + std::to_string(count(visible)) + " points>";
      });
}

}  // namespace hottel::python
