#include "python/bindings/visible_map.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/scene_names.h"
#include "geometry/space/visibility/seen_faces.h"
#include "kernel/support/parallel.h"
#include "python/bindings/bindings.h"

namespace hottel::python {
namespace {

// Numbers names by their first use.
class Places {
 public:
  explicit Places(const Scene3& scene, std::vector<std::string>& names) : scene_(scene), names_(names) {}
  std::int32_t of(const Face& face) {
    const auto [place, is_new] = known_.emplace(face.number(), static_cast<std::int32_t>(names_.size()));
    if (is_new) names_.push_back(face_name(scene_, face));
    return place->second;
  }

 private:
  const Scene3& scene_;
  std::vector<std::string>& names_;
  std::map<std::size_t, std::int32_t> known_;
};

void append(const VisibilityMap3& map, Places& places, MapLists& lists) {
  for (const VisibilityMap3::Share& share : map.shares) {
    lists.face.push_back(places.of(share.face));
    lists.fraction.push_back(share.fraction);
  }
  for (const VisibilityMap3::Fragment& fragment : map.fragments) {
    lists.piece_face.push_back(places.of(fragment.face));
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
      const VisibilityMap3::Corner& corner = map.corners[c];
      lists.directions.insert(lists.directions.end(), {corner.direction.x, corner.direction.y, corner.direction.z});
      lists.xyz.insert(lists.xyz.end(), {corner.x, corner.y, corner.z});
    }
    lists.corner_begin.push_back(static_cast<std::int64_t>(lists.xyz.size() / 3));
  }
}

}  // namespace

MapLists map_lists(const PreparedScene3& prepared, const PythonPoints& points, const StageProgress& progress) {
  constexpr std::size_t kPart = 64;
  const Arrangement3& arrangement = prepared.arrangement();
  const Occluders3 occluders(arrangement.polygons());
  MapLists lists;
  Places places(prepared.scene, lists.names);
  for (std::size_t first = 0; first < points.size(); first += kPart) {
    const std::size_t end = std::min(points.size(), first + kPart);
    std::vector<std::optional<VisibilityMap3>> maps(end - first);
    parallel_for(end - first, [&](std::size_t k) {
      const Point3 eye = points.in_space(first + k);
      if (!arrangement.solids().around(eye)) maps[k] = faces_seen_from(eye, occluders, arrangement);
    });
    for (const std::optional<VisibilityMap3>& map : maps) {
      if (map) append(*map, places, lists);
      lists.sky.push_back(map ? std::max(0.0, map->sky_fraction) : std::numeric_limits<double>::quiet_NaN());
      lists.begin.push_back(static_cast<std::int64_t>(lists.face.size()));
      lists.piece_begin.push_back(static_cast<std::int64_t>(lists.piece_face.size()));
    }
    progress("maps of points", static_cast<double>(end) / static_cast<double>(points.size()));
  }
  return lists;
}

PythonVisibleMap::PythonVisibleMap(MapLists lists) : names(std::move(lists.names)) {
  const auto corners = static_cast<py::ssize_t>(lists.xyz.size() / 3);
  begin = frozen(std::move(lists.begin));
  face = frozen(std::move(lists.face));
  fraction = frozen(std::move(lists.fraction));
  sky = frozen(std::move(lists.sky));
  piece_begin = frozen(std::move(lists.piece_begin));
  piece_face = frozen(std::move(lists.piece_face));
  corner_begin = frozen(std::move(lists.corner_begin));
  directions = frozen(std::move(lists.directions), {corners, 3});
  xyz = frozen(std::move(lists.xyz), {corners, 3});
}

namespace {

std::pair<std::int64_t, std::int64_t> range_in(const py::array& begin, py::ssize_t k) {
  const auto* const places = static_cast<const std::int64_t*>(begin.data());
  return {places[k], places[k + 1]};
}

py::ssize_t place_of(const PythonVisibleMap& map, py::ssize_t point) {
  const py::ssize_t points = map.sky.size();
  if (point < -points || point >= points)
    throw py::index_error("there are " + std::to_string(points) + " points, and none is number " +
                          std::to_string(point));
  return point < 0 ? point + points : point;
}

// Fractions of all directions, by name.
py::dict fractions(const PythonVisibleMap& map, py::ssize_t point) {
  const py::ssize_t k = place_of(map, point);
  const auto [first, end] = range_in(map.begin, k);
  const auto* const face = static_cast<const std::int32_t*>(map.face.data());
  const auto* const fraction = static_cast<const double*>(map.fraction.data());
  py::dict result;
  for (std::int64_t s = first; s < end; ++s)
    result[py::str(map.names[static_cast<std::size_t>(face[s])])] = fraction[s];
  result["sky"] = static_cast<const double*>(map.sky.data())[k];
  return result;
}

py::list pieces(const PythonVisibleMap& map, py::ssize_t point) {
  const auto [first, end] = range_in(map.piece_begin, place_of(map, point));
  const auto* const face = static_cast<const std::int32_t*>(map.piece_face.data());
  py::list result;
  for (std::int64_t p = first; p < end; ++p) {
    const auto [from, to] = range_in(map.corner_begin, p);
    const py::slice corners(static_cast<py::ssize_t>(from), static_cast<py::ssize_t>(to), 1);
    result.append(
        py::make_tuple(map.names[static_cast<std::size_t>(face[p])], map.directions[corners], map.xyz[corners]));
  }
  return result;
}

}  // namespace

void add_visible_map(py::module_& module) {
  py::class_<PythonVisibleMap> type(module, "VisibleMap",
                                    "What n points of space see: map[k] is a dict of fractions of all directions from "
                                    "point k, by name, the sky last;\n"
                                    "times 4 pi it is the solid angle. IndexError for a point that there is not.");
  type.def_readonly(
          "begin", &PythonVisibleMap::begin,
          "int64 of shape (n + 1,): faces and fractions of point k are begin[k] up to begin[k + 1]. Read only.")
      .def_readonly("face", &PythonVisibleMap::face,
                    "Faces that are seen, int32 of shape (m,): places in names. Read only.")
      .def_readonly("fraction", &PythonVisibleMap::fraction,
                    "What they take of all directions, float64 of shape (m,), from 0 to 1. Read only.")
      .def_readonly("sky", &PythonVisibleMap::sky,
                    "What the sky takes of all directions, float64 of shape (n,); NaN in solids. Read only.")
      .def_readonly("piece_begin", &PythonVisibleMap::piece_begin,
                    "int64 of shape (n + 1,): the pieces of point k are piece_begin[k] up to piece_begin[k + 1]. Read\n"
                    "only.")
      .def_readonly("piece_face", &PythonVisibleMap::piece_face,
                    "Of which face each piece is, int32 of shape (p,): places in names. Read only.")
      .def_readonly(
          "corner_begin", &PythonVisibleMap::corner_begin,
          "int64 of shape (p + 1,): the corners of piece j are corner_begin[j] up to corner_begin[j + 1]. Read\n"
          "only.")
      .def_readonly("directions", &PythonVisibleMap::directions,
                    "Where the corners of pieces are seen, unit vectors, float64 of shape (corners, 3). Read only.")
      .def_readonly("xyz", &PythonVisibleMap::xyz,
                    "Where they are on the faces, float64 of shape (corners, 3), in units of the scene. Read only.")
      .def_property_readonly(
          "names", [](const PythonVisibleMap& map) { return tuple_of(map.names); },
          "The names of the faces that are seen from some point, a tuple of str.")
      .def("pieces", &pieces, py::arg("point"),
           "Returns the pieces that one point sees, a list of (name, directions, points): convex cones, arrays of "
           "shape\n"
           "(corners, 3). IndexError for a point that there is not.")
      .def("__getitem__", &fractions, py::arg("point"))
      .def("__len__", [](const PythonVisibleMap& map) { return map.sky.size(); })
      .def("__repr__", [](const PythonVisibleMap& map) {
        return "<hottel.VisibleMap from " + std::to_string(map.sky.size()) + " points>";
      });
}

}  // namespace hottel::python
