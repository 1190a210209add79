#include "python/bindings/simulation.h"

#include <memory>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/visibility/visibility_polygons.h"
#include "io/results/radiosity_files.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "python/bindings/bindings.h"
#include "python/bindings/factors.h"
#include "python/bindings/frames.h"
#include "python/bindings/graph.h"
#include "python/bindings/grid.h"
#include "python/bindings/judgement.h"
#include "python/bindings/numbers.h"
#include "python/bindings/oriented_light.h"
#include "python/bindings/plan.h"
#include "python/bindings/point_light.h"
#include "python/bindings/radiosity.h"
#include "python/bindings/root_sum.h"
#include "python/bindings/simulation_options.h"
#include "python/bindings/simulation_picture.h"
#include "python/bindings/visible.h"
#include "python/bindings/visible_map.h"
#include "solver/plane/simulation/questions.h"
#include "solver/radiosity/gray_exchange.h"
#include "solver/store.h"

namespace hottel::python {

std::shared_ptr<const ExchangeMatrix> matrix_of(const AnySimulation& simulation, const StageProgress& progress) {
  return std::visit(
      [&progress](const auto& each) {
        each.require_closed(progress);
        const auto computed = each.factors(progress);
        return std::shared_ptr<const ExchangeMatrix>(computed, &computed->matrix);
      },
      simulation);
}

namespace {

// The same factors once more, with visibilities.
MatrixWithVisibility with_visibility(const AnySimulation& simulation, const StageProgress& progress) {
  if (const auto* const plane = std::get_if<Simulation2>(&simulation)) {
    SimulationRequest2 request = plane->request();
    request.wants_visibility = true;
    const Simulation2 wider = plane->with_request(std::move(request));
    const auto matrix = matrix_of(wider, progress);
    return {matrix, hidden_pairs(*wider.prepared(progress), wider.granularity(), *matrix)};
  }
  SimulationRequest3 request = std::get<Simulation3>(simulation).request();
  request.factors.wants_visibility = true;
  const Simulation3 wider = std::get<Simulation3>(simulation).with_request(request);
  const auto matrix = matrix_of(wider, progress);
  return {matrix, *wider.hidden(progress)};
}

}  // namespace

template <class Values>
py::array PythonSimulation::light_at(const Values& values_at) const {
  PointLightValues found = without_lock(options_.waiting, values_at);
  const auto channels = static_cast<py::ssize_t>(found.channels);
  const auto points = static_cast<py::ssize_t>(found.values.size()) / channels;
  return frozen(std::move(found.values), {points, channels});
}

PythonSimulation::Solved PythonSimulation::solve() const {
  return waited([](const AnySimulation& simulation, const StageProgress& progress) {
    Solved solved;
    solved.solution = std::visit([&](const auto& each) { return each.radiosities(progress); }, simulation);
    solved.matrix = matrix_of(simulation, progress);
    return solved;
  });
}

PythonSimulation PythonSimulation::of(const PythonScene& scene, SimulationOptions options) {
  require_sense(options, scene.is_plane());
  auto simulation = without_lock(options.waiting, [&](const StageProgress& progress) {
    return refined_by(options, simulation_of(divided(scene.scene(), options), options, store_of(options)), progress);
  });
  return {scene, std::move(options), std::move(simulation)};
}

PythonSimulation PythonSimulation::with_scene(const PythonScene& scene) const {
  if (scene.is_plane() != scene_.is_plane()) throw UsageError("the other scene is of another dimension");
  auto simulation = waited([&](const AnySimulation&, const StageProgress& progress) {
    hottel::Scene other = divided(scene.scene(), options_);
    if (auto* const plane = std::get_if<Scene2>(&other))
      return refined_by(options_, in_the_plane().with_scene(std::move(*plane)), progress);
    return refined_by(options_, in_space().with_scene(std::get<Scene3>(std::move(other))), progress);
  });
  return {scene, options_, std::move(simulation)};
}

py::object PythonSimulation::factors() {
  return kept(factors_, [this] {
    const auto matrix =
        waited([](const auto& simulation, const auto& progress) { return matrix_of(simulation, progress); });
    const bool is_exact = options_.method == "exact";
    return py::cast(PythonFactors(matrix, is_exact, [options = options_, simulation = simulation_] {
      if (options.method != "exact") throw UsageError("visibilities are of the method 'exact'");
      return without_lock(options.waiting, [&simulation](const StageProgress& progress) {
        return with_visibility(*simulation, progress);
      });
    }));
  });
}

py::object PythonSimulation::script_f(const std::string& channel) {
  if (options_.method != "exact") throw UsageError("script-F is of the method 'exact'");
  if (!channel.empty() && scene_.table().has_bands)
    throw UsageError("the scene has two bands, not r, g and b: script-F is of the thermal one");
  const py::str key(channel);
  if (script_f_.contains(key)) return script_f_[key];
  const auto gray = waited([&](const AnySimulation& simulation, const StageProgress& progress) {
    const auto matrix = matrix_of(simulation, progress);
    const std::vector<Material>& materials = scene_.table().materials;
    const auto memory = static_cast<std::uint64_t>(options_.memory.value_or(0));
    return std::make_shared<const ExchangeMatrix>(gray_exchange(*matrix, materials,
                                                                {.channel = gray_channel(*matrix, materials, channel),
                                                                 .memory = memory_allowed(memory),
                                                                 .progress = telling("script-F", progress)}));
  });
  script_f_[key] = PythonFactors(gray, true, []() -> MatrixWithVisibility {
    throw UsageError("visibilities are of view factors, not of script-F");
  });
  return script_f_[key];
}

std::shared_ptr<const std::variant<MethodComparison2, MethodComparison3>> PythonSimulation::comparison() {
  using Any = std::variant<MethodComparison2, MethodComparison3>;
  if (!comparison_)
    comparison_ = waited([](const AnySimulation& simulation, const StageProgress& progress) {
      if (const auto* const plane = std::get_if<Simulation2>(&simulation))
        return std::make_shared<const Any>(std::in_place_type<MethodComparison2>, *plane, progress);
      return std::make_shared<const Any>(std::in_place_type<MethodComparison3>, std::get<Simulation3>(simulation),
                                         progress);
    });
  return comparison_;
}

py::object PythonSimulation::store_use() const {
  const auto store = is_plane() ? in_the_plane().request().store : in_space().request().factors.store;
  if (!store) return py::none();
  const StoreUse use = store->use();
  py::dict result;
  result["computed"] = use.computed;
  result["read"] = use.read;
  result["damaged"] = use.damaged;
  return result;
}

py::object PythonSimulation::radiosity() {
  return kept(radiosity_, [this] {
    const Solved solved = solve();
    return py::cast(radiosity_table(scene_.table(), *solved.matrix, *solved.solution));
  });
}

py::object PythonSimulation::temperatures() {
  return kept(temperatures_, [this] {
    const Solved solved = solve();
    return py::cast(temperature_table(scene_.table(), *solved.matrix, *solved.solution));
  });
}

py::object PythonSimulation::flux(std::vector<NetFlux> NetFluxes::*which, py::object& place) {
  return kept(place, [this, which] {
    const Solved solved = solve();
    const NetFluxes fluxes = waited([&](const AnySimulation& simulation, const StageProgress& progress) {
      return std::visit(
          [&](const auto& each) {
            return NetFluxes(each.scene(), *solved.matrix, *solved.solution, *each.light_shares(progress));
          },
          simulation);
    });
    return py::cast(flux_table(fluxes, fluxes.*which, to_string(solved.solution->guarantee)));
  });
}

py::array PythonSimulation::light(const py::object& array, bool is_binary) const {
  if (scene_.is_plane()) {
    const PythonPoints points(array, 2, is_binary);
    return light_at([&](const StageProgress& progress) { return light_at_points(in_the_plane(), points, progress); });
  }
  const PythonPoints points(array, 3, is_binary);
  return light_at([&](const StageProgress& progress) { return light_at_points(in_space(), points, progress); });
}

py::object PythonSimulation::visible(const py::object& array, const py::object& range, bool is_binary) const {
  const PythonPoints points(array, scene_.is_plane() ? 2 : 3, is_binary);
  if (!scene_.is_plane()) {
    if (!range.is_none()) throw UsageError("range is of scenes in the plane; this version does not have it in space");
    return py::cast(PythonVisibleMap(without_lock(options_.waiting, [&](const StageProgress& progress) {
      return map_lists(*in_space().prepared(progress), points, progress);
    })));
  }
  PolygonsOptions2 wanted;
  if (!range.is_none()) wanted.range = rational_of(range, is_binary, "range");
  if (wanted.range && *wanted.range <= 0) throw UsageError("range is a distance above 0");
  return py::cast(PythonVisible(without_lock(options_.waiting, [&](const StageProgress& progress) {
    const auto prepared = in_the_plane().prepared(progress);
    return visible_lists(*prepared, polygons_of(*prepared, points, wanted, progress));
  })));
}

py::dict PythonSimulation::exact_form(const std::string& from, const std::string& to) const {
  if (!scene_.is_plane())
    throw UsageError("closed forms are of scenes in the plane; this version does not have them in space");
  const ExactPair2 pair = waited([&](const AnySimulation&, const StageProgress& progress) {
    in_the_plane().prepared(progress);
    return exact_pair(in_the_plane(), from, to);
  });
  py::dict result;
  result["exchange"] = pair.exchange.to_string();
  result["unobstructed"] = pair.unobstructed.to_string();
  result["area_from"] = pair.area_from.to_string();
  result["area_to"] = pair.area_to.to_string();
  return result;
}

std::string PythonSimulation::text() const {
  return std::string("<hottel.Simulation of a scene in ") + (scene_.is_plane() ? "the plane" : "space") + ", method " +
         options_.method + ">";
}

namespace {

constexpr const char* kDoc =
    "A scene simulated: what is asked for is made when it is asked for, once, and kept.\n\n"
    "Simulation(scene, *, elements=None, element_size=None, per=None, method='exact', tolerance=None, "
    "guarantee='estimated',\n"
    "sky=None, solver='auto', iterations=None, until=None, memory=None, simulate='auto', store=None, "
    "levels=0, light_levels=0,\nthreads=None, progress=None).\n"
    "Names and values are those of options of the program. per: 'face', 'element' or 'group'; by default elements\n"
    "where the scene is divided. tolerance, guarantee and sky are of scenes in space. memory: bytes. store: a file "
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
          "Returns a pair of the plane in closed form, a dict of 'exchange' (the area times the view factor),\n"
          "'unobstructed' (what it would be with nothing between), 'area_from' and 'area_to': sums of square roots as\n"
          "str, '-2 + 1*sqrt(5)', in units of the scene. UsageError for names that there are not, and in space.")
      .def(
          "light", &PythonSimulation::light, py::arg("points"), py::kw_only(), py::arg("binary") = false,
          "Returns the mean irradiance at n points, float64 of shape (n, c) by channel, [W/m] in the plane, [W/m2] in\n"
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
  add_oriented_light_questions(type);
  add_picture_questions(type);
  type.def("__repr__", &PythonSimulation::text);
}

}  // namespace hottel::python
