#include "python/bindings/graph.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/plane/visibility/visibility_graph.h"
#include "geometry/space/exchange/vertex_graph.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"

namespace hottel::python {
namespace {

// What is found, with nothing of Python.
struct FoundGraph {
  std::vector<double> vertices, lengths;
  std::vector<std::string> surfaces, names;
  std::vector<std::int64_t> pairs;
  std::vector<std::int32_t> along;  // surfaces, or -1
};

// Where a vertex is. Throws RequestError where that is beyond the range of doubles.
void add_vertex(const PreparedScene2& prepared, const GraphVertex2& vertex, FoundGraph& graph) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const std::string& name = prepared.scene.surfaces[vertex.surface].name;
  for (const double x : to_doubles(vertices.to_scene(vertices.exact(vertex.id)))) {
    if (!std::isfinite(x)) throw RequestError("a vertex of '" + name + "' is beyond the range of doubles");
    graph.vertices.push_back(x);
  }
  graph.surfaces.push_back(name);
}

FoundGraph found_in(const PreparedScene2& prepared, const StageProgress& progress) {
  FoundGraph graph;
  for (const GraphVertex2& vertex : graph_vertices(prepared)) add_vertex(prepared, vertex, graph);
  for (const Surface& surface : prepared.scene.surfaces) graph.names.push_back(surface.name);
  const auto add = [&](std::span<const VisiblePair2> pairs) {
    for (const VisiblePair2& pair : pairs) {
      if (!std::isfinite(pair.length)) throw RequestError("a length is beyond the range of doubles");
      graph.pairs.insert(graph.pairs.end(), {pair.v, pair.w});
      graph.lengths.push_back(pair.length);
      graph.along.push_back(
          pair.along == kNoPiece
              ? -1
              : static_cast<std::int32_t>(prepared.arrangement.sources(piece_of(pair.along)).front().surface));
    }
  };
  visibility_graph(prepared, add, telling("visibility graph", progress));
  return graph;
}

FoundGraph found_in(const PreparedScene3& prepared, const StageProgress& progress) {
  FoundGraph graph;
  const std::vector<GraphVertex3> vertices = graph_vertices_3(prepared.scene);
  for (const GraphVertex3& vertex : vertices) {
    const std::array<double, 3> place = to_doubles(vertex.point);
    graph.vertices.insert(graph.vertices.end(), place.begin(), place.end());
    graph.surfaces.push_back(prepared.scene.surfaces[vertex.surface].name);
  }
  for (const double x : graph.vertices)
    if (!std::isfinite(x)) throw RequestError("a vertex is beyond the range of doubles");
  for (const Surface& surface : prepared.scene.surfaces) graph.names.push_back(surface.name);
  for (const VisiblePair3& pair : visibility_graph_3(prepared, telling("visibility graph", progress))) {
    graph.pairs.insert(graph.pairs.end(), {pair.v, pair.w});
    graph.lengths.push_back(length_between(vertices[pair.v].point, vertices[pair.w].point));
    if (!std::isfinite(graph.lengths.back())) throw RequestError("a length is beyond the range of doubles");
    graph.along.push_back(pair.along ? static_cast<std::int32_t>(*pair.along) : -1);
  }
  return graph;
}

PythonGraph graph_of(const PythonSimulation& simulation) {
  FoundGraph graph = simulation.waited([](const AnySimulation& any, const StageProgress& progress) {
    if (const auto* const space = std::get_if<Simulation3>(&any)) return found_in(*space->prepared(progress), progress);
    const Simulation2 by_faces = std::get<Simulation2>(any).with_request({.granularity = Granularity::kFace});
    return found_in(*by_faces.prepared(progress), progress);
  });
  const py::ssize_t dimension = simulation.is_plane() ? 2 : 3;
  const auto vertices = static_cast<py::ssize_t>(graph.surfaces.size());
  const auto pairs = static_cast<py::ssize_t>(graph.lengths.size());
  return {frozen(std::move(graph.vertices), {vertices, dimension}),
          frozen(std::move(graph.pairs), {pairs, 2}),
          frozen(std::move(graph.lengths)),
          frozen(std::move(graph.along)),
          std::move(graph.surfaces),
          std::move(graph.names)};
}

}  // namespace

void add_graph(py::module_& module) {
  py::class_<PythonGraph>(module, "VisibilityGraph",
                          "Which vertices of a scene see each other, exactly: n vertices, m pairs.")
      .def_readonly("vertices", &PythonGraph::vertices,
                    "Ends of surfaces, then crossings, float64 of shape (n, 2); in space corners of polygons, (n, 3); "
                    "in units of\n"
                    "the scene. Read only.")
      .def_readonly("pairs", &PythonGraph::pairs,
                    "Numbers of two vertices that see each other, the lower first, int64 of shape (m, 2). Read only.")
      .def_readonly("lengths", &PythonGraph::lengths,
                    "How far they are apart, float64 of shape (m,), in units of the scene. Read only.")
      .def_readonly("along", &PythonGraph::along,
                    "The surface on the segment between them, int32 of shape (m,): a place in names; -1 where the\n"
                    "segment is free. Read only.")
      .def_property_readonly(
          "surfaces", [](const PythonGraph& graph) { return tuple_of(graph.surfaces); },
          "By vertex the first surface that ends there, or crosses another, a tuple of n str.")
      .def_property_readonly(
          "names", [](const PythonGraph& graph) { return tuple_of(graph.names); },
          "The names of all surfaces, a tuple of str.")
      .def("__repr__", [](const PythonGraph& graph) {
        return "<hottel.VisibilityGraph of " + std::to_string(graph.surfaces.size()) + " vertices, " +
               std::to_string(graph.lengths.size()) + " pairs>";
      });
}

void add_graph_questions(py::class_<PythonSimulation>& type) {
  type.def("visibility_graph", &graph_of,
           "Returns which vertices of the scene see each other, VisibilityGraph, as `hottel visibility --graph`.\n"
           "RequestError where coordinates are beyond the range of doubles.");
}

}  // namespace hottel::python
