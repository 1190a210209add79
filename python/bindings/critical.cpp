#include "python/bindings/critical.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/visibility/critical_lines.h"
#include "geometry/plane/visibility/critical_points.h"
#include "io/results/plane/edge_report.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "python/bindings/numbers.h"

namespace hottel::python {
namespace {

// Returns work(prepared, progress) of the scene by faces.
template <class Work>
auto by_faces(const PythonSimulation& simulation, const char* what, const Work& work) {
  if (!simulation.is_plane()) throw UsageError(std::string(what) + " are for scenes in the plane");
  return simulation.waited([&work](const AnySimulation& any, const StageProgress& progress) {
    const Simulation2 faces = std::get<Simulation2>(any).with_request({.granularity = Granularity::kFace});
    return work(*faces.prepared(progress), progress);
  });
}

// Adds the coordinates of a point, each the nearest double. Throws RequestError beyond the range of doubles.
void add_point(const Point2& point, const char* what, std::vector<double>& values) {
  for (const double x : to_doubles(point)) {
    if (!std::isfinite(x)) throw RequestError(std::string(what) + " is beyond the range of doubles");
    values.push_back(x);
  }
}

PythonCriticalPoints points_between(const PythonSimulation& simulation, const std::string& from,
                                    const std::string& to) {
  if (from == "sky") throw UsageError("critical points are those of a face: the sky has none");
  const std::vector<CriticalPoint2> found =
      by_faces(simulation, "critical points", [&](const PreparedScene2& prepared, const StageProgress&) {
        const Face a = face_of(prepared.scene, from);
        std::optional<Face> b;
        if (to != "sky") b = face_of(prepared.scene, to);
        require_free(prepared, a);
        if (b) require_free(prepared, *b);
        return critical_points(prepared, a, b);
      });
  PythonCriticalPoints result;
  std::vector<double> t, points, near, far;
  std::vector<std::uint8_t> is_jump;
  for (const CriticalPoint2& point : found) {
    t.push_back(to_double(point.t));
    add_point(point.point, "a critical point", points);
    add_point(point.near, "a vertex", near);
    add_point(point.far, "a vertex", far);
    is_jump.push_back(point.is_jump ? 1 : 0);
    result.exact_t.push_back(point.t);
  }
  const auto n = static_cast<py::ssize_t>(found.size());
  result.t = frozen(std::move(t));
  result.points = frozen(std::move(points), {n, 2});
  result.near = frozen(std::move(near), {n, 2});
  result.far = frozen(std::move(far), {n, 2});
  result.is_jump = frozen(std::move(is_jump)).attr("view")("bool");
  return result;
}

// What is found, with nothing of Python.
struct FoundLines {
  std::vector<double> vertices, ends;
  std::vector<std::string> along;
  std::vector<std::vector<std::string>> met, seen;
};

void add_line(const PreparedScene2& prepared, const CriticalLine2& line, FoundLines& lines) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto name_where_any = [&](PieceSideId side) { return side == kNoPiece ? "" : met_name(prepared, side); };
  add_point(line.from, "a vertex", lines.vertices);
  add_point(line.to, "a vertex", lines.vertices);
  lines.along.push_back(
      line.along == kNoPiece
          ? ""
          : prepared.scene.surfaces[prepared.arrangement.sources(piece_of(line.along)).front().surface].name);
  auto& met = lines.met.emplace_back();
  auto& seen = lines.seen.emplace_back();
  for (const LineReach2* reach : {&line.behind, &line.ahead}) {
    if (reach->end)
      add_point(*reach->end, "an end of a critical line", lines.ends);
    else
      lines.ends.insert(lines.ends.end(), {kNan, kNan});
    for (const PieceSideId side : {reach->left, reach->right}) met.push_back(met_name(prepared, side));
    for (const PieceSideId side : {reach->seen_from_left, reach->seen_from_right}) seen.push_back(name_where_any(side));
  }
}

PythonCriticalLines lines_of(const PythonSimulation& simulation) {
  FoundLines lines =
      by_faces(simulation, "critical lines", [](const PreparedScene2& prepared, const StageProgress& progress) {
        FoundLines found;
        for (const CriticalLine2& line : critical_lines(prepared, telling("critical lines", progress)))
          add_line(prepared, line, found);
        return found;
      });
  const auto n = static_cast<py::ssize_t>(lines.along.size());
  return {frozen(std::move(lines.vertices), {n, 2, 2}), frozen(std::move(lines.ends), {n, 2, 2}),
          std::move(lines.along), std::move(lines.met), std::move(lines.seen)};
}

py::tuple tuples_of(const std::vector<std::vector<std::string>>& lists) {
  py::tuple result(lists.size());
  for (std::size_t k = 0; k < lists.size(); ++k) result[k] = tuple_of(lists[k]);
  return result;
}

void add_lines(py::module_& module) {
  py::class_<PythonCriticalLines>(module, "CriticalLines",
                                  "The n lines through two vertices of a scene in the plane along which what is seen "
                                  "changes, exactly:\nthe columns of `hottel visibility --events`.")
      .def_readonly("vertices", &PythonCriticalLines::vertices,
                    "The two vertices of each, float64 of shape (n, 2, 2), in units of the scene. Read only.")
      .def_readonly("ends", &PythonCriticalLines::ends,
                    "Where each ends behind its first vertex and ahead of its second, float64 of shape (n, 2, 2), in "
                    "units of\nthe scene; NaN where it goes on for ever. Read only.")
      .def_property_readonly(
          "along", [](const PythonCriticalLines& lines) { return tuple_of(lines.along); },
          "The surface on the segment between the vertices, a tuple of n str; '' where it is free.")
      .def_property_readonly(
          "met", [](const PythonCriticalLines& lines) { return tuples_of(lines.met); },
          "What each meets, moved a little: behind to the left and to the right, ahead to the left and to the right; "
          "a\n"
          "tuple of n tuples of 4 str, names of faces, 'sky' or '#solid'.")
      .def_property_readonly(
          "seen", [](const PythonCriticalLines& lines) { return tuples_of(lines.seen); },
          "What each separates: seen between the vertices by an eye just behind them, on the left of the line and on\n"
          "the right, and by one just ahead; a tuple of n tuples of 4 str, '' where it does not reach there.")
      .def("__len__", [](const PythonCriticalLines& lines) { return lines.along.size(); })
      .def("__repr__", [](const PythonCriticalLines& lines) {
        return "<hottel.CriticalLines, " + std::to_string(lines.along.size()) + " of them>";
      });
}

}  // namespace

void add_critical(py::module_& module) {
  py::class_<PythonCriticalPoints>(module, "CriticalPoints",
                                   "The n points of a face at which its view of another face, or of the sky, changes: "
                                   "where a line touches\ntwo vertices, by ascending t.")
      .def_readonly("t", &PythonCriticalPoints::t,
                    "Where they are on the surface, float64 of shape (n,), 0 at its first point, 1 at its second. Read "
                    "only.")
      .def_property_readonly(
          "exact_t",
          [](const PythonCriticalPoints& points) {
            py::list result;
            for (const Rational& t : points.exact_t) result.append(fraction_of(t));
            return py::tuple(result);
          },
          "The same with nothing rounded, a tuple of n fractions.Fraction.")
      .def_readonly("points", &PythonCriticalPoints::points,
                    "The points, float64 of shape (n, 2), in units of the scene. Read only.")
      .def_readonly("near", &PythonCriticalPoints::near,
                    "The nearer vertex of each line, float64 of shape (n, 2), in units of the scene. Read only.")
      .def_readonly("far", &PythonCriticalPoints::far,
                    "The farther vertex of each line, float64 of shape (n, 2), in units of the scene. Read only.")
      .def_readonly("is_jump", &PythonCriticalPoints::is_jump,
                    "Whether something touches the face there, so that the view jumps; else it has a kink. bool of "
                    "shape (n,).\nRead only.")
      .def("__len__", [](const PythonCriticalPoints& points) { return points.exact_t.size(); })
      .def("__repr__", [](const PythonCriticalPoints& points) {
        return "<hottel.CriticalPoints, " + std::to_string(points.exact_t.size()) + " of them>";
      });
  add_lines(module);
}

void add_critical_questions(py::class_<PythonSimulation>& type) {
  type.def("critical_points", &points_between, py::arg("from_name"), py::arg("to_name"),
           "Returns where the view that a face of the plane has of another face, or of 'sky', changes: "
           "CriticalPoints, as of\n`hottel visibility --from A --to B`. UsageError for names that there are not, and "
           "in space; RequestError for a face\nin a solid, and beyond the range of doubles.")
      .def("critical_lines", &lines_of,
           "Returns the critical lines of a scene in the plane, CriticalLines, as `hottel visibility --events`. "
           "UsageError in\nspace, RequestError where coordinates are beyond the range of doubles.");
}

}  // namespace hottel::python
