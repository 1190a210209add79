#include "solver/space/simulation/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/closed_promise.h"
#include "geometry/space/exchange/closed_promise.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/scene/validation.h"
#include "geometry/unmeasured_pairs.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stage.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/methods/negative_factors.h"
#include "solver/radiosity/radiosity_sources.h"
#include "solver/radiosity/scene_radiosities.h"
#include "solver/refinement.h"
#include "solver/space/dividing/estimate.h"
#include "solver/space/light/average_irradiance.h"
#include "solver/space/light/scene_light_shares.h"
#include "solver/space/light/tested_shares.h"
#include "solver/space/scene_memory.h"
#include "solver/space/scene_plan.h"
#include "solver/space/simulation/cached_factors.h"

namespace hottel {
namespace {

template <class T>
using StagePtr = std::shared_ptr<Stage<T>>;
using ScenePtr = std::shared_ptr<const Scene3>;

// What an approximate method makes of a scene.
ComputedFactors3 factors_by(const ExchangeMethod3& method, const PreparedScene3& prepared,
                            const FactorsRequest3& request, const StageProgress& progress) {
  ComputedFactors3 result;
  MethodReport report;
  try {
    result.matrix = method.compute(
        prepared,
        {.granularity = request.granularity, .wants_visibility = false, .progress = telling("view factors", progress)},
        report);
  } catch (const RequestError& error) {
    throw RequestError(fmt::format("{}: the method {}: {}", prepared.scene.file, method.info().name, error.what()));
  }
  result.report.surfaces = report.counts.surfaces;
  result.report.vertices = report.counts.vertices;
  result.report.elements = report.counts.elements;
  result.report.pairs = report.counts.pairs;
  result.report.max_defect = report.row_defect;
  result.report.seconds = report.counts.seconds;
  result.notes = {method_sentence(method.info(), result.matrix, report)};
  result.notes.insert(result.notes.end(), report.notes.begin(), report.notes.end());
  return result;
}

// What is asked of the factors of cells: their bounds are what averages are for.
ExchangeRequest request_of_cells(const FactorsRequest3& asked, const std::function<void(double)>& progress) {
  return {.granularity = asked.granularity,
          .tolerance = asked.tolerance,
          .proves = true,
          .sky = asked.sky,
          .memory = memory_allowed(asked.memory),
          .progress = progress};
}

ComputedFactors3 make_factors(const PreparedScene3& prepared, const FactorsRequest3& request,
                              const StageProgress& progress) {
  const bool tells_elements_apart = request.method && request.method->works_by_elements();
  require_memory(prepared.scene, {.granularity = tells_elements_apart ? Granularity::kElement : request.granularity},
                 request.memory);
  const ExchangeRequest asked{.granularity = request.granularity,
                              .wants_visibility = request.wants_visibility,
                              .wants_measures = request.wants_measures,
                              .tolerance = request.tolerance,
                              .proves = request.must_be_enclosed,
                              .sky = request.sky,
                              .rows = request.rows,
                              .memory = memory_allowed(request.memory)};
  if (request.method) {
    const auto compute = [&] { return factors_by(*request.method, prepared, request, progress); };
    return request.store ? cached_factors_3(*request.store, *request.method, prepared, asked, compute) : compute();
  }
  return with_file_context_of_pairs(prepared.scene.file, [&] {
    ComputedFactors3 result;
    const std::function<void(double)> told = telling("view factors", progress);
    ExchangeRows3 rows(prepared, asked);
    Stopwatch watch;
    std::optional<StoreTable> table;
    if (request.store) table = store_table_3(rows, prepared, asked);
    const std::uint64_t taken = table ? take_kept(*request.store, *table, asked, rows) : 0;
    std::uint64_t kept = 0;
    double seconds = watch.lap();
    if (table)
      rows.hand_on([&](std::span<const PairSum3> pairs, const PairRanges& known) {
        Stopwatch keeping;
        kept += keep_pairs(*request.store, *table, asked, pairs, known);
        seconds += keeping.lap();
      });
    if (request.watch == nullptr) rows.add_all(told);
    const double all = rows.missing();
    while (rows.missing() > 0) {
      const std::vector<std::uint32_t> next = request.watch->next(rows);
      const double begin = 1 - rows.missing() / all, part = static_cast<double>(next.size()) / all;
      request.watch->have_come(rows, rows.add(next, [&](double done) { told(begin + part * done); }));
    }
    if (table) request.store->add(kept, taken);
    result.matrix = rows.matrix(&result.report);
    if (table) result.report.seconds["store"] = seconds;
    if (request.must_be_enclosed) require_enclosed_3(result.matrix, request.tolerance);
    return result;
  });
}

StagePtr<PreparedScene3> prepared_stage(const ScenePtr& scene) {
  return std::make_shared<Stage<PreparedScene3>>("preparation",
                                                 [scene](const StageProgress&) { return prepare(*scene); });
}

// The same arrangement under a scene with other materials.
StagePtr<PreparedScene3> prepared_stage(const ScenePtr& scene, const StagePtr<PreparedScene3>& before) {
  return std::make_shared<Stage<PreparedScene3>>(
      "preparation", [scene, before](const StageProgress& progress) { return before->get(progress)->under(*scene); });
}

// All of a scene that its arrangement, and factors, come from but for its materials.
bool is_same_shape(const Scene3& a, const Scene3& b) {
  return a.file == b.file && a.unit == b.unit && a.polygons == b.polygons && a.masks == b.masks &&
         a.groups == b.groups && a.bases == b.bases &&
         std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_alike_undivided) &&
         std::ranges::equal(a.materials, b.materials, {}, &Material::name, &Material::name);
}

// Whether polygons, and what patches lie on, are the same.
bool has_places_of(const Scene3& a, const Scene3& b) {
  const auto is_alike = [](const Surface& s, const Surface& t) {
    return s.on == t.on && s.group == t.group && s.name == t.name;
  };
  return a.polygons == b.polygons && a.bases == b.bases && a.groups == b.groups &&
         std::ranges::equal(a.surfaces, b.surfaces, is_alike);
}

// Whether each light shines on the same: their shares are the same then.
bool are_lit_alike(const Scene3& a, const Scene3& b) {
  if (a.lights.size() != b.lights.size()) return false;
  for (std::size_t k = 0; k < a.lights.size(); ++k)
    if (!is_lit_alike_3(a.lights[k], a.light_places[k], b.lights[k], b.light_places[k])) return false;
  return true;
}

StagePtr<Plan> plan_stage(const StagePtr<PreparedScene3>& prepared, const SimulationRequest3& request) {
  return std::make_shared<Stage<Plan>>(
      "plan", [prepared, plan = request.plan, sky = request.factors.sky](const StageProgress& progress) {
        return plan_scene(*prepared->get(progress), plan, sky);
      });
}

}  // namespace

struct Simulation3::Version {
  ScenePtr scene;
  SimulationRequest3 request;
  StagePtr<Plan> plan;
  StagePtr<PreparedScene3> arranged;  // of the materials that it was arranged with
  StagePtr<PreparedScene3> prepared;
  StagePtr<ComputedFactors3> measured;  // of the materials that they were measured with
  StagePtr<ComputedFactors3> factors;
  StagePtr<std::vector<ElementPair>> hidden;
  StagePtr<LitElements3> lit;  // without the lights that shine on them
  StagePtr<std::vector<LightShares>> shares;
  StagePtr<RadiositySolver> system;
  StagePtr<RadiositySolution> radiosities;
  StagePtr<DividingEstimate> dividing;
  StagePtr<IlluminationGrid3> light;  // null: there is no grid
  StagePtr<LightPicture3> picture;    // null: or no painter

  // Of another request of the scene, or of the first.
  Version(ScenePtr its_scene, const SimulationRequest3& its_request, const Version* other)
      : scene(std::move(its_scene)), request(its_request) {
    require_grid();
    const bool keeps_factors = other != nullptr && other->request.factors == request.factors;
    const bool keeps_lights = keeps_factors && other->request.lights == request.lights;
    const bool keeps_system = keeps_factors && other->request.system == request.system;
    arranged = other != nullptr ? other->arranged : prepared_stage(scene);
    prepared = other != nullptr ? other->prepared : arranged;
    const bool keeps_plan =
        other != nullptr && other->request.plan == request.plan && other->request.factors.sky == request.factors.sky;
    plan = keeps_plan ? other->plan : plan_stage(prepared, request);
    if (keeps_factors) {
      measured = other->measured;
      factors = other->factors;
      hidden = other->hidden;
      lit = other->lit;
      shares = other->shares;
    } else {
      set_factors();
    }
    if (keeps_factors && !keeps_lights) set_shares();
    const bool keeps_radiosities = keeps_system && keeps_lights;
    if (keeps_system) system = other->system;
    if (keeps_radiosities) {
      radiosities = other->radiosities;
      dividing = other->dividing;
    } else {
      set_system(keeps_system);
    }
    if (keeps_radiosities && other->grid() == grid() && other->request.light.is_average == request.light.is_average)
      light = other->light;
    if (light != nullptr && other->request.light.painter == request.light.painter) picture = other->picture;
    set_light();
  }

  // Of another scene.
  Version(const Version& other, ScenePtr its_scene) : scene(std::move(its_scene)), request(other.request) {
    require_grid();
    const bool has_same_shape = is_same_shape(*other.scene, *scene);
    const bool are_alike = has_same_shape && are_alike_as_before_3(other.scene->materials, scene->materials);
    const bool has_same_elements =
        has_same_shape && std::ranges::equal(other.scene->surfaces, scene->surfaces, &Surface::is_divided_alike);
    arranged = are_alike ? other.arranged : prepared_stage(scene);
    prepared = are_alike ? prepared_stage(scene, arranged) : arranged;
    plan = plan_stage(prepared, request);
    if (!has_same_elements) {
      set_factors();
    } else if (are_alike) {
      measured = other.measured;
      factors = other.factors;
      hidden = other.hidden;
      lit = other.lit;
      shares = other.shares;
      if (!are_lit_alike(*other.scene, *scene)) set_shares();
    } else {  // it is refused, or arranged as before
      measured = other.measured;
      factors = std::make_shared<Stage<ComputedFactors3>>(
          "view factors",
          [ready = prepared, before = measured, asked = request.factors](const StageProgress& progress) {
            const auto there = ready->get(progress);
            try {
              return *before->get(progress);
            } catch (const InputError&) {  // that one was refused
              return make_factors(*there, asked, progress);
            }
          });
      set_hidden();
      set_lit();
      set_shares();
    }
    const bool keeps_system = factors == other.factors && scene->closed == other.scene->closed &&
                              reflectivities_of(scene->materials) == reflectivities_of(other.scene->materials);
    if (keeps_system) system = other.system;
    set_system(keeps_system);
    set_light();
  }

  std::optional<Grid3> grid() const {
    if (request.light.grid || scene->grids.empty()) return request.light.grid;
    return scene->grids.front();
  }

 private:
  void require_grid() const {
    if (const std::string problem = request.light.grid ? grid_problem(*request.light.grid) : ""; !problem.empty())
      throw UsageError("the grid of a request: " + problem);
    if (const auto where = grid(); request.light.is_average && where && where->is_volume())
      throw UsageError("averages are of the irradiance of cells on a side, and a volume has none");
  }

  void set_factors() {
    factors = std::make_shared<Stage<ComputedFactors3>>(
        "view factors", [ready = prepared, asked = request.factors](const StageProgress& progress) {
          return make_factors(*ready->get(progress), asked, progress);
        });
    measured = factors;
    set_hidden();
    set_lit();
    set_shares();
  }

  void set_lit() {
    lit = std::make_shared<Stage<LitElements3>>(
        "lights", [ready = prepared, of = request.factors.granularity](const StageProgress& progress) {
          return LitElements3(ready->get(progress), of);
        });
  }

  void set_shares() {
    shares = std::make_shared<Stage<std::vector<LightShares>>>(
        "lights", [its = scene, ready = prepared, elements = lit, of = request.factors.granularity,
                   by = request.lights](const StageProgress& progress) {
          if (its->lights.empty()) return std::vector<LightShares>();
          return by == LightTest::kExact ? elements->get(progress)->shares(*its)
                                         : hottel::light_shares(*ready->get(progress), of, by);
        });
  }

  void set_hidden() {
    hidden = std::make_shared<Stage<std::vector<ElementPair>>>(
        "hidden pairs", [ready = prepared, made = factors, asked = request.factors](const StageProgress& progress) {
          const auto there = ready->get(progress);
          const auto computed = made->get(progress);
          return with_file_context(
              there->scene.file, [&] { return hidden_pairs(*there, asked.granularity, computed->matrix, asked.rows); });
        });
  }

  void set_system(bool has_system) {
    if (!has_system) make_system();
    radiosities = std::make_shared<Stage<RadiositySolution>>(
        "radiosity", [its = scene, made = factors, ready = system, of_lights = shares](const StageProgress& progress) {
          const auto solver = ready->get(progress);
          const auto lights = of_lights->get(progress);
          return scene_radiosities(*solver, *its, *lights, made->get(progress)->notes, telling("radiosity", progress));
        });
    dividing = std::make_shared<Stage<DividingEstimate>>(
        "dividing", [ready = prepared, made = factors, solved = radiosities, of_lights = shares,
                     asked = request.factors, by = request.lights](const StageProgress& progress) {
          const auto solution = solved->get(progress);
          const auto there = ready->get(progress);
          const auto computed = made->get(progress);
          const auto lights = of_lights->get(progress);
          return with_file_context(there->scene.file, [&] {
            return estimate_dividing({.prepared = *there,
                                      .solved = {there->scene, computed->matrix, *solution, *lights},
                                      .granularity = asked.granularity,
                                      .has_exact_factors = asked.method == nullptr,
                                      .lights = by,
                                      .progress = telling("dividing", progress)});
          });
        });
  }

  // Those that are not there.
  void set_light() {
    if (!grid()) return;
    if (light == nullptr)
      light = std::make_shared<Stage<IlluminationGrid3>>(
          "illumination", [ready = prepared, solved = radiosities, where = *grid(), asked = request.factors,
                           is_average = request.light.is_average](const StageProgress& progress) {
            const auto solution = solved->get(progress);
            const auto there = ready->get(progress);
            const auto told = telling("illumination", progress);
            return with_file_context_of_pairs(there->scene.file, [&] {
              return is_average ? average_irradiance(*there, *solution, where, request_of_cells(asked, told))
                                : illuminate_points(*there, asked.granularity, *solution, where, told);
            });
          });
    if (picture == nullptr && request.light.painter != nullptr && !grid()->is_volume())
      picture = std::make_shared<Stage<LightPicture3>>(
          "picture", [lit = light, painter = request.light.painter](const StageProgress& progress) {
            const auto values = lit->get(progress);
            Stopwatch watch;
            LightPicture3 result = painter->paint(*values);
            result.seconds = watch.lap();
            return result;
          });
  }

  void make_system() {
    system = std::make_shared<Stage<RadiositySolver>>(
        "radiosity", [its = scene, made = factors, ready = prepared, asked = request.system,
                      method = request.factors.method, rows = request.factors.rows](const StageProgress& progress) {
          require_all(rows);
          const auto computed = made->get(progress);
          if (method == nullptr) {
            hottel::require_closed(*its, computed->matrix);
          } else {  // an error of the method is none of the scene
            if (its->closed) hottel::require_closed(*ready->get(progress));
            require_not_negative(computed->matrix, its->file, method->info().name);
          }
          return with_file_context(its->file, [&] {
            return RadiositySolver(std::shared_ptr<const ExchangeMatrix>(computed, &computed->matrix),
                                   reflectivities_of(its->materials),
                                   {.solver = asked.solver,
                                    .iterations = asked.iterations,
                                    .until = asked.until,
                                    .serves_many = asked.serves_many});
          });
        });
  }
};

Simulation3::Simulation3(ValidScene3 scene, SimulationRequest3 request)
    : version_(std::make_shared<const Version>(std::make_shared<const Scene3>(std::move(scene)), request, nullptr)) {}

Simulation3 Simulation3::with_request(const SimulationRequest3& request) const {
  return Simulation3(std::make_shared<const Version>(version_->scene, request, version_.get()));
}

Simulation3 Simulation3::with_materials(std::vector<Material> materials) const {
  HOTTEL_REQUIRE(materials.size() == version_->scene->materials.size());
  Scene3 scene = *version_->scene;
  scene.materials = std::move(materials);
  validate_table(scene);
  return Simulation3(std::make_shared<const Version>(*version_, std::make_shared<const Scene3>(std::move(scene))));
}

Simulation3 Simulation3::with_scene(Scene3 scene) const {
  if (!has_places_of(scene, *version_->scene)) return with_scene(ValidScene3(std::move(scene)));
  validate_but_polygons(scene);
  return Simulation3(std::make_shared<const Version>(*version_, std::make_shared<const Scene3>(std::move(scene))));
}

Simulation3 Simulation3::with_scene(ValidScene3 scene) const {
  return Simulation3(std::make_shared<const Version>(*version_, std::make_shared<const Scene3>(std::move(scene))));
}

Simulation3 Simulation3::with_trees(std::vector<SurfaceTrees> trees) const {
  auto scene = std::make_shared<const Scene3>(hottel::with_trees(*version_->scene, std::move(trees)));
  return Simulation3(std::make_shared<const Version>(*version_, std::move(scene)));
}

bool are_alike_as_before_3(const std::vector<Material>& before, const std::vector<Material>& now) {
  HOTTEL_REQUIRE(before.size() == now.size());
  for (std::size_t a = 0; a < now.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if ((before[a] == before[b]) != (now[a] == now[b])) return false;
  return true;
}

const Scene3& Simulation3::scene() const { return *version_->scene; }
const SimulationRequest3& Simulation3::request() const { return version_->request; }
std::optional<Grid3> Simulation3::grid() const { return version_->grid(); }

std::shared_ptr<const Plan> Simulation3::plan(const StageProgress& progress) const {
  return version_->plan->get(progress);
}
std::shared_ptr<const PreparedScene3> Simulation3::prepared(const StageProgress& progress) const {
  return version_->prepared->get(progress);
}
std::shared_ptr<const ComputedFactors3> Simulation3::factors(const StageProgress& progress) const {
  return version_->factors->get(progress);
}
void Simulation3::require_closed(const StageProgress& progress) const {
  if (!scene().closed) return;
  if (request().factors.method == nullptr && request().factors.rows.is_all())
    hottel::require_closed(scene(), factors(progress)->matrix);
  else
    hottel::require_closed(*prepared(progress));
}
std::shared_ptr<const std::vector<LightShares>> Simulation3::light_shares(const StageProgress& progress) const {
  return version_->shares->get(progress);
}
std::shared_ptr<const RadiositySolver> Simulation3::system(const StageProgress& progress) const {
  return version_->system->get(progress);
}
std::shared_ptr<const RadiositySolution> Simulation3::radiosities(const StageProgress& progress) const {
  return version_->radiosities->get(progress);
}
std::shared_ptr<const DividingEstimate> Simulation3::dividing(const StageProgress& progress) const {
  return version_->dividing->get(progress);
}
std::shared_ptr<const IlluminationGrid3> Simulation3::light(const StageProgress& progress) const {
  HOTTEL_REQUIRE(version_->light != nullptr);
  return version_->light->get(progress);
}
std::shared_ptr<const LightPicture3> Simulation3::picture(const StageProgress& progress) const {
  HOTTEL_REQUIRE(version_->picture != nullptr);
  return version_->picture->get(progress);
}
std::shared_ptr<const std::vector<ElementPair>> Simulation3::hidden(const StageProgress& progress) const {
  return version_->hidden->get(progress);
}

}  // namespace hottel
