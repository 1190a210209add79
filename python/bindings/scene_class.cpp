// The class Scene as Python sees it, and how files are read.
#include <algorithm>
#include <filesystem>

#include "geometry/scene_names.h"
#include "io/scene/plane/map_reader.h"
#include "io/scene/space/vs3_reader.h"
#include "io/scene/table_writer.h"
#include "kernel/support/failure.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/numbers.h"
#include "python/bindings/picture.h"
#include "python/bindings/scene.h"
#include "python/bindings/scene_text.h"

namespace hottel::python {
namespace {

// A scene, and what is to be said of how it was read: what was passed over, which polygons were cut.
struct NotedScene {
  ValidScene scene;
  std::vector<std::string> notes;
};

NotedScene read_noting(const std::filesystem::path& file, bool triangulates, MapSide2 side) {
  Triangulator3 triangulator;
  PassedOver passed_over;
  NotedScene noted;
  Triangulator3* const used = triangulates ? &triangulator : nullptr;
  if (is_vs3(file)) {
    Vs3Scene3 deck = read_vs3_3(file, used);
    noted = {std::move(deck.scene), std::move(deck.notes)};
  } else {
    noted.scene = read_scene(file, used, &passed_over, side);
  }
  for (const std::string& note : {passed_over.note(), triangulator.note()})
    if (!note.empty()) noted.notes.push_back(note);
  return noted;
}

PythonScene from_file(const std::filesystem::path& file, bool triangulates, const std::string& front) {
  if (front != "inside" && front != "outside") throw UsageError("front is 'inside' or 'outside', not '" + front + "'");
  const auto noted = [&] {
    const py::gil_scoped_release released;
    return read_noting(file, triangulates, front == "inside" ? MapSide2::kInside : MapSide2::kOutside);
  }();
  for (const std::string& note : noted.notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
  return PythonScene(noted.scene);
}

std::vector<std::string> names_of(const PythonScene& scene) {
  std::vector<std::string> names;
  for (const Surface& surface : scene.table().surfaces) names.push_back(surface.name);
  return names;
}

template <class Named>
py::tuple names_in(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& each : list) names.push_back(each.name);
  return tuple_of(names);
}

// The corners of a surface, each coordinate the double nearest to it.
py::array points_of(const PythonScene& scene, const std::string& name) {
  const auto place = scene.table().find(name);
  if (!place) surfaces_matching(scene.table(), name);  // says which names are near
  if (!place) throw UsageError("'" + name + "' is not one surface");
  std::vector<double> values;
  if (scene.is_plane()) {
    const Edge2& edge = scene.in_plane().edges[*place];
    for (const Point2* point : {&edge.from, &edge.to})
      for (const double x : to_doubles(*point)) values.push_back(x);
    return frozen(std::move(values), {2, 2});
  }
  for (const Point3& point : scene.in_space().polygons[*place].points)
    for (const double x : to_doubles(point)) values.push_back(x);
  const auto count = static_cast<py::ssize_t>(values.size() / 3);
  return frozen(std::move(values), {count, 3});
}

void move(Edge2& edge, const std::vector<Rational>& by) {
  for (Point2* point : {&edge.from, &edge.to}) *point = {point->x + by[0], point->y + by[1]};
}

void move(Point3& point, const std::vector<Rational>& by) {
  point = {point.x + by[0], point.y + by[1], point.z + by[2]};
}

void move(Polygon3& polygon, const std::vector<Rational>& by) {
  for (Point3& point : polygon.points) move(point, by);
  for (std::vector<Point3>& hole : polygon.holes)
    for (Point3& point : hole) move(point, by);
  for (std::array<Point3, 3>& facet : polygon.facets)
    for (Point3& point : facet) move(point, by);
}

PythonScene moved(const PythonScene& scene, const std::string& pattern, const py::sequence& vector, bool is_binary) {
  const std::size_t dimension = scene.is_plane() ? 2 : 3;
  if (vector.size() != dimension)
    throw UsageError("the vector of a scene of dimension " + std::to_string(dimension) + " has " +
                     std::to_string(dimension) + " numbers, not " + std::to_string(vector.size()));
  std::vector<Rational> by;
  for (std::size_t k = 0; k < dimension; ++k)
    by.push_back(rational_of(py::object(vector[k]), is_binary, "vector[" + std::to_string(k) + "]"));
  const std::vector<std::uint32_t> which = surfaces_matching(scene.table(), pattern);
  if (scene.is_plane()) {
    Scene2 plane = scene.in_plane();
    for (const std::uint32_t s : which) move(plane.edges[s], by);
    return PythonScene(ValidScene2(std::move(plane)));
  }
  Scene3 space = scene.in_space();
  for (const std::uint32_t s : which) move(space.polygons[s], by);
  return PythonScene(ValidScene3(std::move(space)));
}

py::dict dict_of(const PythonScene& scene) {
  const py::module_ decimal = py::module_::import("decimal");
  return py::module_::import("json").attr("loads")(scene.text(), py::arg("parse_float") = decimal.attr("Decimal"));
}

PythonScene replaced(const PythonScene& scene, const py::kwargs& keys) {
  py::dict table = dict_of(scene);
  for (const auto& [key, value] : keys) {
    if (value.is_none() && table.contains(key))
      table.attr("pop")(key);
    else if (!value.is_none())
      table[key] = value;
  }
  return scene_of(table);
}

constexpr std::size_t kShownSurfaces = 8;

std::string materials_text(const SceneTable& table, const Surface& surface) {
  const auto name = [&table](std::optional<std::uint32_t> material) {
    return material ? table.materials[*material].name : std::string("-");
  };
  return name(surface.material_of(false)) + "  " + name(surface.material_of(true));
}

// A few lines: what there is, and the first surfaces.
std::string short_table(const PythonScene& scene) {
  const SceneTable& table = scene.table();
  const std::size_t count = table.surfaces.size(), shown = std::min(count, kShownSurfaces);
  std::string text = std::string("<hottel.Scene in ") + (scene.is_plane() ? "the plane" : "space") + ": " +
                     std::to_string(count) + (scene.is_plane() ? " edges, " : " polygons, ") +
                     std::to_string(table.materials.size()) + " materials, " + std::to_string(table.lights.size()) +
                     " lights\n  name  front  back";
  for (std::size_t s = 0; s < shown; ++s)
    text += "\n  " + table.surfaces[s].name + "  " + materials_text(table, table.surfaces[s]);
  if (shown < count) text += "\n  ... " + std::to_string(count - shown) + " more";
  return text + ">";
}

bool are_equal(const PythonScene& a, const PythonScene& b) {
  return a.is_plane() == b.is_plane() && a.key() == b.key();
}

void add_properties(py::class_<PythonScene>& type) {
  type.def_property_readonly(
          "dimension", [](const PythonScene& scene) { return scene.is_plane() ? 2 : 3; }, "2 in the plane, 3 in space.")
      .def_property_readonly(
          "names", [](const PythonScene& scene) { return tuple_of(names_of(scene)); },
          "The names of the surfaces, a tuple of str in the order of the scene.")
      .def_property_readonly(
          "materials", [](const PythonScene& scene) { return names_in(scene.table().materials); },
          "The names of the materials, a tuple of str.")
      .def_property_readonly(
          "lights", [](const PythonScene& scene) { return names_in(scene.table().lights); },
          "The names of the lights, a tuple of str.")
      .def_property_readonly(
          "channels", [](const PythonScene& scene) { return tuple_of(channel_names(scene.table())); },
          "What radiosities have a column each for: ('all',), ('r', 'g', 'b') or ('solar', 'thermal').")
      .def_property_readonly(
          "unit", [](const PythonScene& scene) { return length_unit(scene.table()); },
          "The unit of length of the scene, 'm' where it says none.")
      .def_property_readonly(
          "closed", [](const PythonScene& scene) { return scene.table().closed; },
          "Whether the scene promises that no front with a material sees the sky.");
}

// Plans are shown as shapes, views in space as pixels; what cannot be drawn is shown as text.
py::object shown_in_notebook(const PythonScene& scene, bool as_shapes) {
  if (scene.is_plane() != as_shapes) return py::none();
  try {
    const PythonPicture picture = scene_picture(scene, as_shapes ? 800 : 0, false);
    if (!as_shapes) return picture.file("png");
    return picture.file("svg").attr("decode")("utf-8");
  } catch (const RequestError&) {
    return py::none();
  }
}

void add_pictures(py::class_<PythonScene>& type) {
  type.def("picture", &scene_picture, py::kw_only(), py::arg("size") = 0, py::arg("axes") = false,
           "Returns a picture of the scene by itself, Picture: in the plane its plan, in space what its camera sees,\n"
           "each face in about the light that it may have.\n\n"
           "size: pixels across, 0 for the usual. axes: coordinates along the frame, in the plane. UsageError for a\n"
           "size that is none, RequestError where it cannot be drawn.")
      .def("_repr_png_", [](const PythonScene& scene) { return shown_in_notebook(scene, false); })
      .def("_repr_svg_", [](const PythonScene& scene) { return shown_in_notebook(scene, true); });
}

void add_methods(py::class_<PythonScene>& type) {
  type.def("points", &points_of, py::arg("name"),
           "Returns the corners of the surface of that name, float64 of shape (2, 2) for an edge and (k, 3) for a\n"
           "polygon, in units of the scene, each the nearest double. Read only. UsageError where there is none.")
      .def("moved", &moved, py::arg("name"), py::arg("vector"), py::kw_only(), py::arg("binary") = false,
           "Returns the scene with the surfaces of that name (of a group, or 'wall*') moved by a vector of 2 or 3\n"
           "numbers, in units of the scene, exactly. UsageError for a name that there is not, InputError for numbers\n"
           "that are none, and where surfaces may not lie so.")
      .def(
          "replace", &replaced,
          "replace(**keys): returns the scene with other values of keys of its file, as of the dict of to_dict(): all\n"
          "of 'materials', 'edges', 'sky', ... None takes a key away. Errors as of Scene().")
      .def("to_dict", &dict_of,
           "Returns the scene as a dict that Scene() takes, every number exact: int, decimal.Decimal, or str such as\n"
           "'1/3'. RequestError where a mesh has polygons that are plane only but for rounding.")
      .def("to_json", &PythonScene::text,
           "Returns the text of a scene file (str) that reads back to the same scene. RequestError as to_dict().");
}

}  // namespace

void add_scene(py::module_& module) {
  py::class_<PythonScene> type(
      module, "Scene",
      "A scene in the plane or in space. It never changes; what changes it returns another one.\n\n"
      "Scene(table, folder=None, binary=False) takes a dict with the keys of a scene file, where \"hottel\" may be "
      "left\n"
      "out. An int, str, fractions.Fraction or decimal.Decimal is exact; a float is its shortest decimal, as in a "
      "file:\n"
      "0.1 is one tenth. With binary=True a float is the double that it is. Files of meshes are found in the folder.\n"
      "Throws InputError for what is no scene, TypeError for objects that no scene holds.");
  type.def(py::init([](const py::dict& table, const std::optional<std::filesystem::path>& folder, bool binary) {
             return scene_of(table, folder.value_or(""), binary);
           }),
           py::arg("table"), py::arg("folder") = py::none(), py::kw_only(), py::arg("binary") = false,
           "Makes a scene of a dict; see the class.");
  add_properties(type);
  add_methods(type);
  add_pictures(type);
  type.def("__len__", [](const PythonScene& scene) { return scene.table().surfaces.size(); })
      .def("__repr__", &short_table)
      .def("__eq__", &are_equal, py::is_operator())
      .def("__hash__", [](const PythonScene& scene) { return py::hash(py::str(scene.key())); })
      .def(py::pickle([](const PythonScene& scene) { return py::str(scene.text()); },
                      [](const py::str& text) { return scene_of_text(text.cast<std::string>()); }));
  module.def(
      "read_scene", &from_file, py::arg("path"), py::kw_only(), py::arg("triangulate") = false,
      py::arg("front") = "inside",
      "Reads a scene of any kind of file that the program reads: .json, drawings (.svg), maps (.geojson, .wkt),\n"
      "meshes (.obj, .ply, .off, .stl) and decks of View3D (.vs3).\n\n"
      "path: str or os.PathLike. triangulate: polygons that are not plane are read as triangles NAME[k]. front:\n"
      "'inside' or 'outside', of the polygons of a map. What is passed over in a file is told by a UserWarning. Throws "
      "InputError with .file, .line and .reason.\n\n"
      ">>> scene = hottel.read_scene(\"scenes/analytic/strip_obstructed.json\")\n"
      ">>> scene.dimension, scene.names\n"
      "(2, ('bottom', 'top', 'obstruction'))\n");
}

}  // namespace hottel::python
