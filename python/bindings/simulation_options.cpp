#include "python/bindings/simulation_options.h"

#include <cmath>
#include <limits>

#include "geometry/near_names.h"
#include "geometry/plane/scene/division.h"
#include "geometry/space/scene/division.h"
#include "io/external/external_method.h"
#include "io/external/plane/external_matrix.h"
#include "io/external/space/external_matrix.h"
#include "io/store/factor_store.h"
#include "kernel/support/failure.h"
#include "solver/plane/simulation/refined.h"
#include "solver/space/simulation/refined.h"

namespace hottel::python {
namespace {

void require_within(const char* name, const std::optional<std::int64_t>& value, std::int64_t most) {
  if (value && (*value < 1 || *value > most))
    throw UsageError(std::string(name) + " is a whole number from 1 to " + std::to_string(most) + ", not " +
                     std::to_string(*value));
}

void require_positive(const char* name, const std::optional<double>& value) {
  if (value && !(*value > 0 && std::isfinite(*value)))
    throw UsageError(std::string(name) + " is a positive number, not " + shortest(*value));
}

void require_one_of(const char* name, const std::string& value, const std::vector<std::string>& known) {
  for (const std::string& each : known)
    if (value == each) return;
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "'" : ", '") + each + "'";
  throw UnknownName(std::string(name) + " is one of " + list + ", not '" + value + "'", value, known);
}

Granularity granularity_of(const std::string& per) {
  require_one_of("per", per, {"face", "element", "group"});
  return per == "face" ? Granularity::kFace : per == "element" ? Granularity::kElement : Granularity::kGroup;
}

// As the program takes --solver, --iterations and --until.
RadiosityOptions system_asked(const SimulationOptions& options, bool has_symmetric_rows) {
  std::vector<std::string> known;
  for (int k = 0; k <= static_cast<int>(Solver::kShooting); ++k) known.push_back(to_string(static_cast<Solver>(k)));
  require_one_of("solver", options.solver, known);
  RadiosityOptions result{.solver = *solver_named(options.solver), .until = options.until};
  if (options.iterations) result.iterations = static_cast<int>(*options.iterations);
  if (!options.iterations && !options.until) return result;
  if (result.solver == Solver::kCholesky || result.solver == Solver::kLu)
    throw UsageError("iterations and until do not apply to '" + options.solver + "', which is direct");
  if (result.solver == Solver::kAuto) result.solver = has_symmetric_rows ? Solver::kCg : Solver::kBicgstab;
  return result;
}

std::uint64_t memory_of(const SimulationOptions& options) {
  return static_cast<std::uint64_t>(options.memory.value_or(0));
}

Simulation2 in_plane(ValidScene2 scene, const SimulationOptions& options, const std::shared_ptr<FactorStore>& store) {
  SimulationRequest2 request;
  request.method = all_methods_2().make(options.method);
  if (options.per) request.granularity = granularity_of(*options.per);
  request.everything = options.simulate == "everything";
  request.system = system_asked(options, options.method == "exact");
  request.memory = memory_of(options);
  request.store = store;
  return Simulation2(std::move(scene), std::move(request));
}

Simulation3 in_space(ValidScene3 scene, const SimulationOptions& options, const std::shared_ptr<FactorStore>& store) {
  SimulationRequest3 request;
  const bool is_by_elements = is_divided(*scene) || options.levels.is_any();
  if (options.method != "exact") request.factors.method = all_methods_3().make(options.method);
  request.factors.granularity = options.per      ? granularity_of(*options.per)
                                : is_by_elements ? Granularity::kElement
                                                 : Granularity::kFace;
  request.factors.tolerance = options.tolerance.value_or(request.factors.tolerance);
  request.factors.sky = options.sky == "closure" ? SkyBy::kClosure : SkyBy::kIntegral;
  request.factors.must_be_enclosed = options.guarantee == "enclosed";
  request.factors.memory = memory_of(options);
  request.factors.store = store;
  request.system = system_asked(options, false);
  request.plan.everything = options.simulate == "everything";
  for (const Grid3& grid : scene->grids) request.plan.grid_cells += grid.cells();
  return Simulation3(std::move(scene), request);
}

template <class AnyValidScene>
void divide(AnyValidScene& scene, const SimulationOptions& options) {
  if (options.elements) divide_into(scene, static_cast<std::uint32_t>(*options.elements));
  if (!options.element_size) return;
  if (const auto surface = divide_by_length(scene, *options.element_size, kMaxElements))
    throw UsageError("element_size asks for more than " + std::to_string(kMaxElements) + " elements on '" +
                     scene->surfaces[*surface].name + "'");
}

}  // namespace

void require_sense(const SimulationOptions& options, bool is_plane) {
  require_within("elements", options.elements, kMaxElements);
  require_within("iterations", options.iterations, std::numeric_limits<int>::max());
  require_within("memory", options.memory, std::numeric_limits<std::int64_t>::max());
  if (options.waiting.threads) require_within("threads", *options.waiting.threads, 4096);
  const auto require_level = [](const char* name, int value) {
    if (value < 0 || value > TreePath::kMostLevels)
      throw UsageError(std::string(name) + " is a whole number from 0 to " + std::to_string(TreePath::kMostLevels));
  };
  require_level("levels", options.levels.everywhere);
  require_level("light_levels", options.levels.at_borders);
  if (options.levels.at_borders > 0 && options.levels.at_borders <= options.levels.everywhere)
    throw UsageError("light_levels change nothing where they are not more than levels");
  if (options.levels.is_any() && options.per && *options.per != "element")
    throw UsageError("levels divide elements: they go with per='element'");
  require_positive("tolerance", options.tolerance);
  require_positive("until", options.until);
  require_one_of("guarantee", options.guarantee, {"estimated", "enclosed"});
  require_one_of("simulate", options.simulate, {"auto", "everything"});
  if (options.sky) require_one_of("sky", *options.sky, {"integration", "closure"});
  if (options.elements && options.element_size) throw UsageError("elements and element_size exclude each other");
  if (options.element_size && *options.element_size <= 0) throw UsageError("element_size is a positive number");
  const bool is_of_space = options.tolerance || options.sky || options.guarantee != "estimated";
  if (is_plane && is_of_space)
    throw UsageError(
        "tolerance, sky and guarantee are for scenes in space: in the plane every factor is correctly "
        "rounded");
  if (options.method != "exact" && (is_of_space || options.memory))
    throw UsageError("tolerance, sky, guarantee and memory are for the method 'exact', not for '" + options.method +
                     "'");
}

ValidScene divided(ValidScene scene, const SimulationOptions& options) {
  std::visit([&options](auto& each) { divide(each, options); }, scene);
  return scene;
}

AnySimulation simulation_of(ValidScene scene, const SimulationOptions& options,
                            const std::shared_ptr<FactorStore>& store) {
  if (auto* const plane = std::get_if<ValidScene2>(&scene)) return in_plane(std::move(*plane), options, store);
  return in_space(std::get<ValidScene3>(std::move(scene)), options, store);
}

std::shared_ptr<const AnySimulation> refined_by(const SimulationOptions& options, AnySimulation simulation,
                                                const StageProgress& progress) {
  if (options.levels.is_any())
    simulation = std::visit([&](const auto& each) -> AnySimulation { return refined(each, options.levels, progress); },
                            simulation);
  return std::make_shared<const AnySimulation>(std::move(simulation));
}

std::shared_ptr<FactorStore> store_of(const SimulationOptions& options) {
  if (!options.store) return nullptr;
  if (is_external(options.method))
    throw UsageError("store keeps what hottel computes, not the factors of " + options.method);
  return open_factor_store(*options.store);
}

}  // namespace hottel::python
