#include "python/bindings/sights.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/scene_names.h"
#include "geometry/space/exchange/event_surfaces.h"
#include "geometry/space/exchange/face_sight.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"

namespace hottel::python {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Returns work(prepared, progress) of a scene in space.
template <class Work>
auto of_space(const PythonSimulation& simulation, const char* what, const Work& work) {
  if (simulation.is_plane()) throw UsageError(std::string(what) + " are for scenes in space");
  return simulation.waited([&work](const AnySimulation& any, const StageProgress& progress) {
    return work(*std::get<Simulation3>(any).prepared(progress), progress);
  });
}

PythonFaceSight sight_of(const PythonSimulation& simulation, const std::string& name) {
  if (name == "sky") throw UsageError("what some point of a face sees is asked of a face, which the sky is not");
  std::vector<std::uint8_t> is_whole;
  PythonFaceSight result;
  const auto found = of_space(
      simulation, "faces that see each other", [&](const PreparedScene3& prepared, const StageProgress& progress) {
        const Face face = face_of(prepared.scene, name);
        require_free(prepared, face);
        std::vector<std::pair<std::string, bool>> names;
        for (const SeenFace3& seen : faces_seen_by(prepared, face, telling("weak visibility", progress)))
          names.emplace_back(seen.face ? face_name(prepared.scene, *seen.face) : "sky", seen.is_whole);
        return names;
      });
  for (const auto& [seen, whole] : found) {
    result.names.push_back(seen);
    is_whole.push_back(whole ? 1 : 0);
  }
  result.is_whole = frozen(std::move(is_whole)).attr("view")("bool");
  return result;
}

// What is found, with nothing of Python.
struct FoundEvents {
  std::vector<std::string> kinds;
  std::vector<double> edges, vertices, others, t, rulings;
  std::vector<std::vector<std::string>> edge_of, crossing;
  std::vector<std::int64_t> begin{0};
};

// Throws RequestError beyond the range of doubles.
template <class Place>
void add_place(const Place& place, std::vector<double>& values) {
  for (const double x : place) {
    if (!std::isfinite(x)) throw RequestError("a coordinate of an event surface is beyond the range of doubles");
    values.push_back(x);
  }
}

void add_edge(const std::array<Point3, 2>& edge, std::vector<double>& values) {
  for (const Point3& end : edge) add_place(to_doubles(end), values);
}

std::vector<std::string> names_of(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  std::vector<std::string> names;
  for (const std::uint32_t s : surfaces) names.push_back(scene.surfaces[s].name);
  return names;
}

void add_event(const Scene3& scene, const EventSurface3& event, FoundEvents& found) {
  found.kinds.emplace_back(event.kind == EventSurface3::Kind::kEV ? "EV" : "EEE");
  add_edge(event.edge, found.edges);
  found.edge_of.push_back(names_of(scene, event.surfaces));
  found.crossing.push_back(names_of(scene, event.crossing));
  event.vertex ? add_place(to_doubles(*event.vertex), found.vertices)
               : void(found.vertices.insert(found.vertices.end(), 3, kNan));
  for (std::size_t k = 0; k < 2; ++k)
    k < event.others.size() ? add_edge(event.others[k], found.others)
                            : void(found.others.insert(found.others.end(), 6, kNan));
  for (const EventSurface3::Ruling& ruling : event.rulings) {
    found.t.push_back(ruling.t);
    add_place(ruling.on_from, found.rulings);
    add_place(ruling.on_to, found.rulings);
  }
  found.begin.push_back(static_cast<std::int64_t>(found.t.size()));
}

PythonEvents events_between(const PythonSimulation& simulation, const std::string& from, const std::string& to) {
  if (from == "sky" || to == "sky") throw UsageError("event surfaces are between two faces, not of the sky");
  FoundEvents found = of_space(simulation, "event surfaces", [&](const PreparedScene3& prepared, const StageProgress&) {
    const Face a = face_of(prepared.scene, from), b = face_of(prepared.scene, to);
    require_free(prepared, a);
    require_free(prepared, b);
    FoundEvents events;
    for (const EventSurface3& event : event_surfaces(prepared, a, b)) add_event(prepared.scene, event, events);
    return events;
  });
  const auto n = static_cast<py::ssize_t>(found.kinds.size()), r = static_cast<py::ssize_t>(found.t.size());
  return {std::move(found.kinds),
          frozen(std::move(found.edges), {n, 2, 3}),
          frozen(std::move(found.vertices), {n, 3}),
          frozen(std::move(found.others), {n, 2, 2, 3}),
          std::move(found.edge_of),
          std::move(found.crossing),
          frozen(std::move(found.begin)),
          frozen(std::move(found.t)),
          frozen(std::move(found.rulings), {r, 2, 3})};
}

py::tuple name_tuples(const std::vector<std::vector<std::string>>& lists) {
  py::tuple result(lists.size());
  for (std::size_t k = 0; k < lists.size(); ++k) result[k] = tuple_of(lists[k]);
  return result;
}

void add_events(py::module_& module) {
  py::class_<PythonEvents>(
      module, "EventSurfaces",
      "The n surfaces of lines between two faces in space along which what one sees of the other "
      "changes, by r of\ntheir lines: the columns of `hottel visibility --events --from A --to B`.")
      .def_property_readonly(
          "kinds", [](const PythonEvents& events) { return tuple_of(events.kinds); },
          "'EV', through an edge and a vertex, or 'EEE', through three edges; a tuple of n str.")
      .def_readonly("edges", &PythonEvents::edges,
                    "The ends of the stretch of an edge that each is through, float64 of shape (n, 2, 3), in units of "
                    "the scene.\nRead only.")
      .def_property_readonly(
          "edge_of", [](const PythonEvents& events) { return name_tuples(events.edge_of); },
          "The surfaces that this edge is of, a tuple of n tuples of str.")
      .def_readonly("vertices", &PythonEvents::vertices,
                    "The vertex of each EV, float64 of shape (n, 3), in units of the scene; NaN for EEE. Read only.")
      .def_readonly("others", &PythonEvents::others,
                    "The two other edges of each EEE, float64 of shape (n, 2, 2, 3), in units of the scene; NaN where "
                    "there is none.\nRead only.")
      .def_property_readonly(
          "crossing", [](const PythonEvents& events) { return name_tuples(events.crossing); },
          "In place of edges of an EEE the surfaces that stand on, or pierce, each other, a tuple of n tuples of str.")
      .def_readonly("begin", &PythonEvents::begin,
                    "Lines of surface k are begin[k] to begin[k + 1] - 1, int64 of shape (n + 1,). Read only.")
      .def_readonly("t", &PythonEvents::t,
                    "Where each line meets the stretch, from 0 to 1, float64 of shape (r,). Read only.")
      .def_readonly(
          "rulings", &PythonEvents::rulings,
          "Where each line meets the planes of both faces, float64 of shape (r, 2, 3), in units of the scene. "
          "Read only.")
      .def("__len__", [](const PythonEvents& events) { return events.kinds.size(); })
      .def("__repr__", [](const PythonEvents& events) {
        return "<hottel.EventSurfaces, " + std::to_string(events.kinds.size()) + " of them>";
      });
}

}  // namespace

void add_sights(py::module_& module) {
  py::class_<PythonFaceSight>(module, "FaceSight",
                              "What at least one point of a face in space sees: the lines of `hottel visibility "
                              "--face`, exactly.")
      .def_property_readonly(
          "names", [](const PythonFaceSight& sight) { return tuple_of(sight.names); },
          "The m faces that are seen, in the order of faces, 'sky' last; a tuple of str.")
      .def_readonly("is_whole", &PythonFaceSight::is_whole,
                    "Whether nothing hides any part of both from each other, bool of shape (m,). Read only.")
      .def("__len__", [](const PythonFaceSight& sight) { return sight.names.size(); })
      .def("__repr__", [](const PythonFaceSight& sight) {
        return "<hottel.FaceSight of " + std::to_string(sight.names.size()) + " faces>";
      });
  add_events(module);
}

void add_sight_questions(py::class_<PythonSimulation>& type) {
  type.def("faces_seen_by", &sight_of, py::arg("name"),
           "Returns what at least one point of a face in space sees, FaceSight, as `hottel visibility --face NAME`.\n"
           "UsageError for names that there are not, and in the plane; RequestError for a face in a solid.")
      .def("event_surfaces", &events_between, py::arg("from_name"), py::arg("to_name"),
           "Returns the surfaces of lines along which what two faces in space see of each other changes, "
           "EventSurfaces, as\n`hottel visibility --events --from A --to B`. UsageError for names that there are not, "
           "and in the plane;\nRequestError for a face in a solid, and beyond the range of doubles.");
}

}  // namespace hottel::python
