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
#include "kernel/support/stage_node.h"
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
#include "solver/stage_inputs.h"

namespace hottel {
namespace {

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

ComputedFactors3 computed_factors(const PreparedScene3& prepared, const FactorsRequest3& request,
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

// All of a scene that its arrangement comes from but for its materials.
bool is_same_shape(const Scene3& a, const Scene3& b) {
  return a.file == b.file && a.unit == b.unit && a.polygons == b.polygons && a.masks == b.masks &&
         a.groups == b.groups && a.bases == b.bases &&
         std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_alike_undivided) &&
         std::ranges::equal(a.materials, b.materials, {}, &Material::name, &Material::name);
}

bool is_divided_alike(const Scene3& a, const Scene3& b) {
  return std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_divided_alike);
}

// Whether polygons, and what patches lie on, are the same.
bool has_places_of(const Scene3& a, const Scene3& b) {
  const auto is_alike = [](const Surface& s, const Surface& t) {
    return s.on == t.on && s.group == t.group && s.name == t.name;
  };
  return a.polygons == b.polygons && a.bases == b.bases && a.groups == b.groups &&
         std::ranges::equal(a.surfaces, b.surfaces, is_alike);
}

// Whether lights are called and shine alike but for their power: their shares, and what is said of them, are the same.
bool are_lit_alike(const Scene3& a, const Scene3& b) {
  if (beams_of(a.lights) != beams_of(b.lights)) return false;
  for (std::size_t k = 0; k < a.lights.size(); ++k)
    if (!is_lit_alike_3(a.lights[k], a.light_places[k], b.lights[k], b.light_places[k])) return false;
  return true;
}

struct ArrangementInput {
  ScenePtr scene;
  friend bool operator==(const ArrangementInput& a, const ArrangementInput& b) {
    return a.scene == b.scene ||
           (is_same_shape(*a.scene, *b.scene) && are_alike_as_before_3(a.scene->materials, b.scene->materials));
  }
};

PreparedScene3 make_arrangement(const ArrangementInput& input, const StageProgress&) { return prepare(*input.scene); }

// The scene of a version, with an arrangement that was made for another.
struct PreparedInput {
  StagePtr<PreparedScene3> arrangement;
  ScenePtr scene;
  friend bool operator==(const PreparedInput&, const PreparedInput&) = default;
};

PreparedScene3 make_prepared(const PreparedInput& input, const StageProgress& progress) {
  return input.arrangement->get(progress)->under(*input.scene);
}

struct PlanInput {
  StagePtr<PreparedScene3> prepared;
  PlanRequest request;
  SkyBy sky = SkyBy::kIntegral;
  friend bool operator==(const PlanInput&, const PlanInput&) = default;
};

Plan make_plan(const PlanInput& input, const StageProgress& progress) {
  return plan_scene(*input.prepared->get(progress), input.request, input.sky);
}

struct FactorsInput {
  StagePtr<PreparedScene3> arrangement;
  ScenePtr scene;  // compared in how its surfaces are divided
  StagePtr<PreparedScene3>
      prepared;  // of the version that it is made for; not compared: what matters of it is arranged
  FactorsRequest3 request;
  // Of a scene of the same shape and division, in which other materials act alike; not compared. This scene is refused,
  // or arranged as that one.
  StagePtr<ComputedFactors3> measured;
  friend bool operator==(const FactorsInput& a, const FactorsInput& b) {
    return a.arrangement == b.arrangement && a.request == b.request && is_divided_alike(*a.scene, *b.scene);
  }
};

ComputedFactors3 make_factors(const FactorsInput& input, const StageProgress& progress) {
  const auto prepared = input.prepared->get(progress);
  if (input.measured) {
    try {
      return *input.measured->get(progress);
    } catch (const InputError&) {  // that scene was refused
    }
  }
  return computed_factors(*prepared, input.request, progress);
}

struct HiddenInput {
  StagePtr<ComputedFactors3> factors;
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  RowChoice rows;
  friend bool operator==(const HiddenInput& a, const HiddenInput& b) { return a.factors == b.factors; }
};

std::vector<ElementPair> make_hidden(const HiddenInput& input, const StageProgress& progress) {
  const auto prepared = input.prepared->get(progress);
  const auto factors = input.factors->get(progress);
  return with_file_context(prepared->scene.file,
                           [&] { return hidden_pairs(*prepared, input.granularity, factors->matrix, input.rows); });
}

// What lights could shine on, without the lights.
struct LitInput {
  StagePtr<PreparedScene3> arrangement;
  ScenePtr scene;                     // compared in how its surfaces are divided
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  friend bool operator==(const LitInput& a, const LitInput& b) {
    return a.arrangement == b.arrangement && a.granularity == b.granularity && is_divided_alike(*a.scene, *b.scene);
  }
};

LitElements3 make_lit(const LitInput& input, const StageProgress& progress) {
  return LitElements3(input.prepared->get(progress), input.granularity);
}

struct LightSharesInput {
  StagePtr<LitElements3> lit;
  ScenePtr scene;                     // compared in its lights
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  LightTest test = LightTest::kExact;
  friend bool operator==(const LightSharesInput& a, const LightSharesInput& b) {
    return a.lit == b.lit && a.test == b.test && are_lit_alike(*a.scene, *b.scene);
  }
};

std::vector<LightShares> make_shares(const LightSharesInput& input, const StageProgress& progress) {
  if (input.scene->lights.empty()) return {};
  return input.test == LightTest::kExact ? input.lit->get(progress)->shares(*input.scene)
                                         : light_shares(*input.prepared->get(progress), input.granularity, input.test);
}

struct SystemInput {
  StagePtr<ComputedFactors3> factors;
  FactorsRequest3 asked;              // of them; not compared
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  ScenePtr scene;                     // compared in its promise `closed`
  Spectra reflectivities;
  SystemRequest3 request;
  friend bool operator==(const SystemInput& a, const SystemInput& b) {
    return a.factors == b.factors && a.reflectivities == b.reflectivities && a.scene->closed == b.scene->closed &&
           a.request == b.request;
  }
};

RadiositySolver make_system(const SystemInput& input, const StageProgress& progress) {
  require_all(input.asked.rows);
  const auto factors = input.factors->get(progress);
  if (input.asked.method == nullptr) {
    require_closed(*input.scene, factors->matrix);
  } else {  // an error of the method is none of the scene
    if (input.scene->closed) require_closed(*input.prepared->get(progress));
    require_not_negative(factors->matrix, input.scene->file, input.asked.method->info().name);
  }
  return with_file_context(input.scene->file, [&] {
    return RadiositySolver(std::shared_ptr<const ExchangeMatrix>(factors, &factors->matrix),
                           input.reflectivities.values,
                           {.solver = input.request.solver,
                            .iterations = input.request.iterations,
                            .until = input.request.until,
                            .serves_many = input.request.serves_many});
  });
}

struct RadiositiesInput {
  StagePtr<RadiositySolver> system;
  StagePtr<ComputedFactors3> factors;  // of the system
  ScenePtr scene;                      // compared in what follows
  Spectra emissions;
  StagePtr<std::vector<LightShares>> shares;  // of the power of the lights
  Spectra powers;
  friend bool operator==(const RadiositiesInput& a, const RadiositiesInput& b) {
    return a.system == b.system && a.emissions == b.emissions && a.shares == b.shares && a.powers == b.powers;
  }
};

RadiositySolution make_radiosities(const RadiositiesInput& input, const StageProgress& progress) {
  const auto solver = input.system->get(progress);
  const auto shares = input.shares->get(progress);
  return scene_radiosities(*solver, *input.scene, *shares, input.factors->get(progress)->notes,
                           telling("radiosity", progress));
}

// What dividing once more would change, estimated.
struct DividingInput {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<ComputedFactors3> factors;
  StagePtr<PreparedScene3> prepared;
  StagePtr<std::vector<LightShares>> shares;
  FactorsRequest3 asked;
  LightTest test = LightTest::kExact;
  friend bool operator==(const DividingInput& a, const DividingInput& b) { return a.radiosities == b.radiosities; }
};

DividingEstimate make_dividing(const DividingInput& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto prepared = input.prepared->get(progress);
  const auto factors = input.factors->get(progress);
  const auto shares = input.shares->get(progress);
  return with_file_context(prepared->scene.file, [&] {
    return estimate_dividing({.prepared = *prepared,
                              .solved = {prepared->scene, factors->matrix, *radiosities, *shares},
                              .granularity = input.asked.granularity,
                              .has_exact_factors = input.asked.method == nullptr,
                              .lights = input.test,
                              .progress = telling("dividing", progress)});
  });
}

struct LightInput {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  std::optional<Grid3> grid;          // nothing: there is no light to ask for
  FactorsRequest3 asked;              // not compared: the radiosities come from them
  bool is_average = false;
  friend bool operator==(const LightInput& a, const LightInput& b) {
    return a.radiosities == b.radiosities && a.grid == b.grid && a.is_average == b.is_average;
  }
};

IlluminationGrid3 make_light(const LightInput& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto prepared = input.prepared->get(progress);
  const auto told = telling("illumination", progress);
  return with_file_context_of_pairs(prepared->scene.file, [&] {
    return input.is_average
               ? average_irradiance(*prepared, *radiosities, *input.grid, request_of_cells(input.asked, told))
               : illuminate_points(*prepared, input.asked.granularity, *radiosities, *input.grid, told);
  });
}

struct PictureInput {
  StagePtr<IlluminationGrid3> light;
  std::shared_ptr<const LightPainter3> painter;
  friend bool operator==(const PictureInput&, const PictureInput&) = default;
};

LightPicture3 make_picture(const PictureInput& input, const StageProgress& progress) {
  const auto light = input.light->get(progress);
  Stopwatch watch;
  LightPicture3 result = input.painter->paint(*light);
  result.seconds = watch.lap();
  return result;
}

}  // namespace

struct Simulation3::Version {
  ScenePtr scene;
  SimulationRequest3 request;

  StageNode<ArrangementInput, PreparedScene3> arranged;
  StageNode<PreparedInput, PreparedScene3> prepared;  // with this scene
  StageNode<PlanInput, Plan> plan;
  StageNode<FactorsInput, ComputedFactors3> factors;
  StageNode<HiddenInput, std::vector<ElementPair>> hidden;
  StageNode<LitInput, LitElements3> lit;
  StageNode<LightSharesInput, std::vector<LightShares>> shares;
  StageNode<SystemInput, RadiositySolver> system;
  StageNode<RadiositiesInput, RadiositySolution> radiosities;
  StageNode<DividingInput, DividingEstimate> dividing;
  StageNode<LightInput, IlluminationGrid3> light;
  StageNode<PictureInput, LightPicture3> picture;

  Version(ScenePtr its_scene, const SimulationRequest3& its_request, const Version* before)
      : scene(std::move(its_scene)), request(its_request) {
    require_grid();
    set_prepared(before);
    set_factors(before);
    set_radiosities(before);
    set_light(before);
  }

  std::shared_ptr<const Version> with(Scene3 other) const {
    return std::make_shared<const Version>(std::make_shared<const Scene3>(std::move(other)), request, this);
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

  void set_prepared(const Version* before) {
    arranged = node_of("preparation", ArrangementInput{scene}, member_of(before, &Version::arranged), make_arrangement);
    const PreparedInput with_scene{arranged.stage, scene};
    if (arranged.input.scene == scene)
      prepared = {with_scene, arranged.stage};
    else
      prepared = node_of("preparation", with_scene, member_of(before, &Version::prepared), make_prepared);
    plan = node_of("plan", PlanInput{prepared.stage, request.plan, request.factors.sky},
                   member_of(before, &Version::plan), make_plan);
  }

  // What was measured for the version before, where it holds for this scene unless that is refused.
  StagePtr<ComputedFactors3> measured(const Version* before) const {
    if (before == nullptr || !(before->request.factors == request.factors) || !is_same_shape(*before->scene, *scene) ||
        !is_divided_alike(*before->scene, *scene))
      return nullptr;
    const FactorsInput& made = before->factors.input;
    return made.measured ? made.measured : before->factors.stage;
  }

  void set_factors(const Version* before) {
    const Granularity granularity = request.factors.granularity;
    factors =
        node_of("view factors", FactorsInput{arranged.stage, scene, prepared.stage, request.factors, measured(before)},
                member_of(before, &Version::factors), make_factors);
    hidden = node_of("hidden pairs", HiddenInput{factors.stage, prepared.stage, granularity, request.factors.rows},
                     member_of(before, &Version::hidden), make_hidden);
    lit = node_of("lights", LitInput{arranged.stage, scene, prepared.stage, granularity},
                  member_of(before, &Version::lit), make_lit);
    shares = node_of("lights", LightSharesInput{lit.stage, scene, prepared.stage, granularity, request.lights},
                     member_of(before, &Version::shares), make_shares);
  }

  void set_radiosities(const Version* before) {
    system = node_of("radiosity",
                     SystemInput{factors.stage, request.factors, prepared.stage, scene,
                                 Spectra{reflectivities_of(scene->materials)}, request.system},
                     member_of(before, &Version::system), make_system);
    radiosities = node_of(
        "radiosity",
        RadiositiesInput{system.stage, factors.stage, scene, emissions_of(*scene), shares.stage, powers_of(*scene)},
        member_of(before, &Version::radiosities), make_radiosities);
    dividing = node_of(
        "dividing",
        DividingInput{radiosities.stage, factors.stage, prepared.stage, shares.stage, request.factors, request.lights},
        member_of(before, &Version::dividing), make_dividing);
  }

  void set_light(const Version* before) {
    light = node_of("illumination",
                    LightInput{radiosities.stage, prepared.stage, grid(), request.factors, request.light.is_average},
                    member_of(before, &Version::light), make_light);
    picture = node_of("picture", PictureInput{light.stage, request.light.painter}, member_of(before, &Version::picture),
                      make_picture);
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
  return Simulation3(version_->with(std::move(scene)));
}

Simulation3 Simulation3::with_scene(Scene3 scene) const {
  if (!has_places_of(scene, *version_->scene)) return with_scene(ValidScene3(std::move(scene)));
  validate_but_polygons(scene);
  return Simulation3(version_->with(std::move(scene)));
}

Simulation3 Simulation3::with_scene(ValidScene3 scene) const { return Simulation3(version_->with(std::move(scene))); }

Simulation3 Simulation3::with_trees(std::vector<SurfaceTrees> trees) const {
  return Simulation3(version_->with(hottel::with_trees(*version_->scene, std::move(trees))));
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
  return version_->plan.stage->get(progress);
}
std::shared_ptr<const PreparedScene3> Simulation3::prepared(const StageProgress& progress) const {
  return version_->prepared.stage->get(progress);
}
std::shared_ptr<const ComputedFactors3> Simulation3::factors(const StageProgress& progress) const {
  return version_->factors.stage->get(progress);
}
void Simulation3::require_closed(const StageProgress& progress) const {
  if (!scene().closed) return;
  if (request().factors.method == nullptr && request().factors.rows.is_all())
    hottel::require_closed(scene(), factors(progress)->matrix);
  else
    hottel::require_closed(*prepared(progress));
}
std::shared_ptr<const std::vector<LightShares>> Simulation3::light_shares(const StageProgress& progress) const {
  return version_->shares.stage->get(progress);
}
std::shared_ptr<const RadiositySolver> Simulation3::system(const StageProgress& progress) const {
  return version_->system.stage->get(progress);
}
std::shared_ptr<const RadiositySolution> Simulation3::radiosities(const StageProgress& progress) const {
  return version_->radiosities.stage->get(progress);
}
std::shared_ptr<const DividingEstimate> Simulation3::dividing(const StageProgress& progress) const {
  return version_->dividing.stage->get(progress);
}
std::shared_ptr<const IlluminationGrid3> Simulation3::light(const StageProgress& progress) const {
  HOTTEL_REQUIRE(grid().has_value());
  return version_->light.stage->get(progress);
}
std::shared_ptr<const LightPicture3> Simulation3::picture(const StageProgress& progress) const {
  HOTTEL_REQUIRE(grid() && !grid()->is_volume() && request().light.painter != nullptr);
  return version_->picture.stage->get(progress);
}
std::shared_ptr<const std::vector<ElementPair>> Simulation3::hidden(const StageProgress& progress) const {
  return version_->hidden.stage->get(progress);
}

}  // namespace hottel
