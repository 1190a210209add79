// The class Simulation as Python sees it: its members, and those that other files add.
#include <memory>

#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "python/bindings/critical.h"
#include "python/bindings/frames.h"
#include "python/bindings/graph.h"
#include "python/bindings/grid.h"
#include "python/bindings/judgement.h"
#include "python/bindings/numbers.h"
#include "python/bindings/oriented_light.h"
#include "python/bindings/plan.h"
#include "python/bindings/root_sum.h"
#include "python/bindings/sights.h"
#include "python/bindings/simulation.h"
#include "python/bindings/simulation_options.h"
#include "python/bindings/simulation_picture.h"

namespace hottel::python {
namespace {

constexpr const char* kDoc =
    "A scene simulated: what is asked for is made when it is asked for, once, and kept.\n\n"
    "Simulation(scene, *, elements=None, element_size=None, per=None, method='exact', tolerance=None, "
    "guarantee='estimated',\n"
    "sky=None, solver='auto', iterations=None, until=None, memory=None, simulate='auto', store=None, "
    "levels=0, light_levels=0,\nthreads=None, progress=None).\n"
    "Names and values are those of options of the program. per: 'face', 'element' or 'group'; by default elements\n"
    "where the scene is divided. tolerance, guarantee and sky are for scenes in space. memory: bytes. store: a file "
    "where\n"
    "view factors are kept from one run to the next. levels: divide every element so often in halves, in space in "
    "four;\n"
    "light_levels: those that the border of a beam or a shadow crosses. threads: at most "
    "so\n"
    "many. progress(stage, fraction) is called meanwhile; what it throws ends the work, and so does Ctrl-C.\n"
    "While anything long runs, other threads of Python run too. Throws UsageError for arguments that make no sense.";

PythonSimulation new_simulation(const PythonScene& scene, std::optional<std::int64_t> elements,
                                const py::object& element_size, std::optional<std::string> per,
                                const std::string& method, std::optional<double> tolerance,
                                const std::string& guarantee, std::optional<std::string> sky, const std::string& solver,
                                std::optional<std::int64_t> iterations, std::optional<double> until,
                                std::optional<std::int64_t> memory, const std::string& simulate,
                                std::optional<std::filesystem::path> store, int levels, int light_levels,
                                std::optional<int> threads, py::object progress) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress is called with a stage and a fraction: it has to be callable");
  SimulationOptions options;
  options.elements = elements;
  options.iterations = iterations;
  options.memory = memory;
  if (!element_size.is_none()) options.element_size = rational_of(element_size, false, "element_size");
  options.tolerance = tolerance;
  options.until = until;
  options.per = std::move(per);
  options.sky = std::move(sky);
  options.method = method;
  options.guarantee = guarantee;
  options.solver = solver;
  options.simulate = simulate;
  options.store = std::move(store);
  options.levels = {levels, light_levels};
  options.waiting = {threads, std::move(progress)};
  return PythonSimulation::of(scene, std::move(options));
}

void add_results(py::class_<PythonSimulation>& type) {
  type.def_property_readonly("scene", &PythonSimulation::scene, "The scene, as it was given.")
      .def_property_readonly(
          "factors", &PythonSimulation::factors,
          "The view factors, Factors. RequestError where the scene promises to be closed and is not,\n"
          "where the memory does not suffice, or a pair in space cannot be measured.")
      .def("script_f", &PythonSimulation::script_f, py::arg("channel") = "",
           "Returns gray-body exchange factors (script-F, reflections counted) with proven bounds, Factors without\n"
           "visibilities.\n\n"
           "channel: 'r', 'g' or 'b', whose reflectivities, where materials are not gray. RequestError where they are\n"
           "not and no channel is chosen, UsageError for another channel, and for other methods than 'exact'.")
      .def_property_readonly("store_use", &PythonSimulation::store_use,
                             "What the file of `store` was asked for, a dict of numbers of pairs: 'computed', 'read',\n"
                             "and records that were 'damaged'; None without a store.")
      .def_property_readonly(
          "radiosity", &PythonSimulation::radiosity,
          "The radiosities of elements with proven bounds, Radiosity. RequestError as of factors, and\n"
          "where there is no solution.")
      .def_property_readonly("temperatures", &PythonSimulation::temperatures,
                             "The temperatures [K] of elements, Temperatures, with no rows where the scene has none.\n"
                             "RequestError as of radiosity.")
      .def_property_readonly("flux", &PythonSimulation::face_flux,
                             "The net fluxes of faces and, last, the sky, NetFlux. RequestError as of radiosity.")
      .def_property_readonly(
          "group_flux", &PythonSimulation::group_flux,
          "The net fluxes of groups: polylines, meshes, single surfaces, and, last, the sky, NetFlux.\n"
          "RequestError as of radiosity.")
      .def_property_readonly("light_flux", &PythonSimulation::light_flux,
                             "The net fluxes of lights, NetFlux. RequestError as of radiosity.");
}

void add_questions(py::class_<PythonSimulation>& type) {
  type.def("with_scene", &PythonSimulation::with_scene, py::arg("scene"),
           "Returns the simulation of another scene of the same dimension, asked for alike. It shares what does not\n"
           "change: after an edit of emissions view factors are not computed again. UsageError for another dimension.")
      .def(
          "exact_form", &PythonSimulation::exact_form, py::arg("from_name"), py::arg("to_name"),
          "Returns a pair in closed form, a dict of 'exchange' (the area times the view factor), and in the plane\n"
          "'unobstructed' (what it would be with nothing between), 'area_from' and 'area_to': sums of square roots as\n"
          "str, '-2 + 1*sqrt(5)', in units of the scene. In space it is of rectangles, with arc tangents and "
          "logarithms.\n"
          "UsageError for names that there are not, RequestError where no closed form is known.")
      .def(
          "light", &PythonSimulation::light, py::arg("points"), py::kw_only(), py::arg("binary") = false,
          "Returns the mean irradiance at n points, float64 of shape (n, c) by channel, [W/m2], in the plane and in\n"
          "space; NaN in solids. Read only.\n\n"
          "points: array-like of shape (n, 2) or (n, 3), in units of the scene; a float is its shortest decimal, with\n"
          "binary=True the double that it is. Throws TypeError, InputError for points that are none.")
      .def("visible", &PythonSimulation::visible, py::arg("points"), py::arg("range") = py::none(), py::kw_only(),
           py::arg("binary") = false,
           "Returns what n points see: in the plane exact visibility polygons, Visible, their corners rounded; in "
           "space exact\n"
           "maps of directions, VisibleMap.\n\n"
           "points and binary: as of light(). range: in the plane, a number; nothing beyond that distance is seen. "
           "Throws\n"
           "TypeError, InputError for points that are none, UsageError for a range in space.");
}

}  // namespace

void add_simulation(py::module_& module) {
  py::class_<PythonSimulation> type(module, "Simulation", kDoc);
  type.def(py::init(&new_simulation), py::arg("scene"), py::kw_only(), py::arg("elements") = py::none(),
           py::arg("element_size") = py::none(), py::arg("per") = py::none(), py::arg("method") = "exact",
           py::arg("tolerance") = py::none(), py::arg("guarantee") = "estimated", py::arg("sky") = py::none(),
           py::arg("solver") = "auto", py::arg("iterations") = py::none(), py::arg("until") = py::none(),
           py::arg("memory") = py::none(), py::arg("simulate") = "auto", py::arg("store") = py::none(),
           py::arg("levels") = 0, py::arg("light_levels") = 0, py::arg("threads") = py::none(),
           py::arg("progress") = py::none(), "Makes a simulation; see the class.");
  add_results(type);
  add_questions(type);
  add_plan_questions(type);
  add_compare_questions(type);
  add_frames_questions(type);
  add_root_sum_questions(type);
  add_grid_questions(type);
  add_graph_questions(type);
  add_critical_questions(type);
  add_sight_questions(type);
  add_oriented_light_questions(type);
  add_picture_questions(type);
  type.def("__repr__", &PythonSimulation::text);
}

}  // namespace hottel::python
