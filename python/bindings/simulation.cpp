#include "python/bindings/simulation.h"

#include <memory>

#include "geometry/name.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/visibility/visibility_polygons.h"
#include "geometry/scene_names.h"
#include "geometry/space/exchange/exact_form.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "python/bindings/bindings.h"
#include "python/bindings/factors.h"
#include "python/bindings/numbers.h"
#include "python/bindings/point_light.h"
#include "python/bindings/radiosity.h"
#include "python/bindings/simulation_options.h"
#include "python/bindings/visible.h"
#include "python/bindings/visible_map.h"
#include "solver/plane/simulation/queries.h"
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
    return {matrix, hidden_pairs(*wider.prepared(progress), wider.granularity(), *matrix, wider.request().rows)};
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
    ValidScene other = divided(scene.scene(), options_);
    if (auto* const plane = std::get_if<ValidScene2>(&other))
      return refined_by(options_, in_the_plane().with_scene(std::move(*plane)), progress);
    return refined_by(options_, in_space().with_scene(std::get<ValidScene3>(std::move(other))), progress);
  });
  return {scene, options_, std::move(simulation)};
}

py::object PythonSimulation::factors() {
  return kept(factors_, [this] {
    const auto matrix =
        waited([](const auto& simulation, const auto& progress) { return matrix_of(simulation, progress); });
    const bool is_exact = options_.method == "exact";
    return py::cast(PythonFactors(matrix, is_exact, [options = options_, simulation = simulation_] {
      if (options.method != "exact") throw UsageError("visibilities are for the method 'exact'");
      return without_lock(options.waiting, [&simulation](const StageProgress& progress) {
        return with_visibility(*simulation, progress);
      });
    }));
  });
}

py::object PythonSimulation::script_f(const std::string& channel) {
  if (options_.method != "exact") throw UsageError("script-F is for the method 'exact'");
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
    throw UsageError("visibilities are for view factors, not for script-F");
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
    if (!range.is_none()) throw UsageError("range is only for scenes in the plane");
    return py::cast(PythonVisibleMap(without_lock(options_.waiting, [&](const StageProgress& progress) {
      return map_lists(*in_space().prepared(progress), points, progress);
    })));
  }
  PolygonsOptions2 wanted;
  if (!range.is_none()) wanted.range = rational_of(range, is_binary, "range");
  if (wanted.range && *wanted.range <= 0) throw UsageError("range is a distance above 0");
  return py::cast(PythonVisible(without_lock(options_.waiting, [&](const StageProgress& progress) {
    const auto prepared = in_the_plane().prepared(progress);
    return visible_lists(*prepared, points, wanted, progress);
  })));
}

std::string PythonSimulation::exchange_in_space(const std::string& from, const std::string& to) const {
  if (from == "sky" || to == "sky") throw UsageError("what is seen of the sky has no closed form in space");
  return waited([&](const AnySimulation&, const StageProgress& progress) {
    const auto prepared = in_space().prepared(progress);
    const ExactForm3 form = exact_form_3(*prepared, face_of(prepared->scene, from), face_of(prepared->scene, to));
    if (!form.exchange)
      throw RequestError("no closed form is known of " + quoted_name(from) + " and " + quoted_name(to) + ": " +
                         form.why_not);
    return form.exchange->to_string();
  });
}

py::dict PythonSimulation::exact_form(const std::string& from, const std::string& to) const {
  py::dict result;
  if (!scene_.is_plane()) {
    result["exchange"] = exchange_in_space(from, to);
    return result;
  }
  const ExactPair2 pair = waited([&](const AnySimulation&, const StageProgress& progress) {
    in_the_plane().prepared(progress);
    return exact_pair(in_the_plane(), from, to);
  });
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

}  // namespace hottel::python
