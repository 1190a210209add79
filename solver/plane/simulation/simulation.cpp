#include "solver/plane/simulation/simulation.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/plane/check/finding.h"
#include "geometry/plane/exchange/closed_promise.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stage_node.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/methods/negative_factors.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/dividing/estimate.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/plane/light/light_rows.h"
#include "solver/plane/light/sent_out.h"
#include "solver/plane/light/solved_light.h"
#include "solver/plane/light/tested_shares.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/scene_memory.h"
#include "solver/plane/scene_plan.h"
#include "solver/plane/simulation/cached_factors.h"
#include "solver/radiosity/radiosity_sources.h"
#include "solver/radiosity/scene_radiosities.h"
#include "solver/refinement.h"
#include "solver/stage_inputs.h"

namespace hottel {
namespace {

using MethodPtr = std::shared_ptr<const ExchangeMethod2>;
using ScenePtr = std::shared_ptr<const Scene2>;

// For each material the first that acts as it does.
std::vector<std::size_t> first_alike(const std::vector<Material>& materials) {
  std::map<std::tuple<std::array<Rational, 3>, std::array<Rational, 3>, std::optional<Rational>, bool>, std::size_t>
      first;
  std::vector<std::size_t> result;
  for (const Material& material : materials)
    result.push_back(
        first
            .try_emplace({material.reflectivity.value, material.emission.value,
                          material.has_given_flux() ? material.emissivity : std::nullopt, material.keeps_gains()},
                         result.size())
            .first->second);
  return result;
}

// All of a scene that its undivided arrangement comes from: its shape, its names, and which materials act alike.
bool is_same_shape(const Scene2& a, const Scene2& b) {
  return a.file == b.file && a.unit == b.unit && a.edges == b.edges &&
         std::ranges::equal(a.surfaces, b.surfaces, &Surface::is_alike_undivided) && a.groups == b.groups &&
         a.bases == b.bases && std::ranges::equal(a.materials, b.materials, {}, &Material::name, &Material::name) &&
         first_alike(a.materials) == first_alike(b.materials);
}

struct ArrangementInput {
  ScenePtr scene;
  friend bool operator==(const ArrangementInput& a, const ArrangementInput& b) {
    return a.scene == b.scene || is_same_shape(*a.scene, *b.scene);
  }
};

PreparedScene2 make_arrangement(const ArrangementInput& input, const StageProgress&) { return prepare(*input.scene); }

// The same arrangement with its surfaces cut into elements.
struct DivisionInput {
  StagePtr<PreparedScene2> arrangement;
  ScenePtr scene;  // of the shape that is arranged
  friend bool operator==(const DivisionInput& a, const DivisionInput& b) {
    return a.arrangement == b.arrangement &&
           (a.scene == b.scene || std::ranges::equal(a.scene->surfaces, b.scene->surfaces, &Surface::is_divided_alike));
  }
};

PreparedScene2 make_divided(const DivisionInput& input, const StageProgress& progress) {
  return prepare_divided(*input.arrangement->get(progress), *input.scene);
}

// The scene of a version, with an arrangement that was made for another.
struct PreparedInput {
  StagePtr<PreparedScene2> arrangement;
  ScenePtr scene;
  friend bool operator==(const PreparedInput&, const PreparedInput&) = default;
};

PreparedScene2 make_prepared(const PreparedInput& input, const StageProgress& progress) {
  const auto other = input.arrangement->get(progress);
  return {*input.scene, other->division, other->shared, other->seconds};
}

struct FactorsInput {
  StagePtr<PreparedScene2> arrangement;
  ScenePtr scene;  // of the version that it is made for; not compared: what matters of it is arranged
  MethodPtr method;
  Granularity granularity = Granularity::kFace;
  RowChoice rows = {};
  bool wants_visibility = false, wants_measures = false, everything = false;
  std::uint64_t memory = 0;
  std::shared_ptr<FactorStore> store = nullptr;  // no number depends on it
  friend bool operator==(const FactorsInput& a, const FactorsInput& b) {
    return a.arrangement == b.arrangement && a.method == b.method && a.granularity == b.granularity &&
           a.rows == b.rows && a.wants_visibility == b.wants_visibility && a.wants_measures == b.wants_measures &&
           a.everything == b.everything && a.memory == b.memory && a.store == b.store;
  }
};

struct SystemInput {
  StagePtr<ComputedFactors2> factors;
  RowChoice rows;  // of factors
  Spectra reflectivities;
  Solver solver = Solver::kAuto;
  std::optional<int> iterations;
  std::optional<double> until;
  std::string file;  // of the scene, for messages
  friend bool operator==(const SystemInput&, const SystemInput&) = default;
};

// What the lights shine on first. Their power is no part of it.
struct LightSharesInput {
  StagePtr<PreparedScene2> arrangement;
  StagePtr<PreparedScene2> prepared;  // of the version that it is made for; not compared: what matters of it follows
  Granularity granularity = Granularity::kFace;
  std::vector<Light> lights;  // without power
  std::vector<LightPlace2> places;
  LightTest test = LightTest::kExact;
  friend bool operator==(const LightSharesInput& a, const LightSharesInput& b) {
    return a.arrangement == b.arrangement && a.granularity == b.granularity && a.lights == b.lights &&
           a.places == b.places && a.test == b.test;
  }
};

struct RadiositiesInput {
  StagePtr<RadiositySolver> system;
  StagePtr<ComputedFactors2> factors;
  MethodPtr method;                   // of the factors
  StagePtr<PreparedScene2> prepared;  // of the version that it is made for; not compared: what matters of it follows
  Spectra emissions;
  StagePtr<std::vector<LightShares>> shares;  // of the power of the lights; null: there are none
  Spectra powers;
  bool closed = false;
  StagePtr<PreparedScene2> divided;  // for the promise
  std::uint64_t memory = 0;
  friend bool operator==(const RadiositiesInput& a, const RadiositiesInput& b) {
    return a.system == b.system && a.emissions == b.emissions && a.shares == b.shares && a.powers == b.powers &&
           a.closed == b.closed;
  }
};

// What dividing once more would change, estimated.
struct DividingInput {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<ComputedFactors2> factors;
  MethodPtr method;                // of the factors
  StagePtr<PreparedScene2> whole;  // undivided, of the version that it is made for; not compared
  StagePtr<std::vector<LightShares>> shares;
  LightTest test = LightTest::kExact;
  std::uint64_t memory = 0;
  friend bool operator==(const DividingInput& a, const DividingInput& b) {
    return a.radiosities == b.radiosities && a.memory == b.memory;
  }
};

struct RowsInput {
  StagePtr<PreparedScene2> arrangement;
  Granularity granularity = Granularity::kFace;
  Grid2 grid;
  std::uint64_t memory = 0;
  friend bool operator==(const RowsInput&, const RowsInput&) = default;
};

struct LightInput {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<PreparedScene2> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  Grid2 grid;
  LightKind2 kind = LightKind2::kPoint;
  StagePtr<LightRows2> rows;  // null: not kept. Not compared: light is the same, bit for bit
  friend bool operator==(const LightInput& a, const LightInput& b) {
    return a.radiosities == b.radiosities && a.granularity == b.granularity && a.grid == b.grid && a.kind == b.kind;
  }
};

struct PictureInput {
  StagePtr<SolvedLight2> light;
  StagePtr<PreparedScene2> prepared;  // not compared, as before
  std::shared_ptr<const LightPainter2> painter;
  friend bool operator==(const PictureInput& a, const PictureInput& b) {
    return a.light == b.light && a.painter == b.painter;
  }
};

struct PlanInput {
  StagePtr<PreparedScene2> prepared;
  PlanRequest request;
  friend bool operator==(const PlanInput&, const PlanInput&) = default;
};

struct LostLightInput {
  StagePtr<PreparedScene2> prepared;
  StagePtr<ComputedFactors2> factors;
  friend bool operator==(const LostLightInput&, const LostLightInput&) = default;
};

struct CheckInput {
  ScenePtr scene;
  StagePtr<PreparedScene2> whole;  // undivided
  StagePtr<ComputedFactors2> exact_factors;
  StagePtr<std::vector<LightShares>> shares;  // of the elements of these
  friend bool operator==(const CheckInput&, const CheckInput&) = default;
};

ComputedFactors2 make_factors(const FactorsInput& input, const StageProgress& progress) {
  const bool tells_elements_apart = input.method->works_by_elements();
  require_memory(*input.scene,
                 {.granularity = tells_elements_apart ? Granularity::kElement : input.granularity,
                  .pairs_on_disk = input.method->keeps_pairs_on_disk()},
                 input.memory);
  const auto prepared = input.arrangement->get(progress);
  const ExchangeRequest asked{.granularity = input.granularity,
                              .wants_visibility = input.wants_visibility,
                              .wants_measures = input.wants_measures,
                              .always_sweeps = input.everything,
                              .rows = input.rows,
                              .memory = memory_allowed(input.memory),
                              .progress = telling("view factors", progress)};
  return input.store ? cached_factors_2(*input.store, *input.method, *prepared, asked)
                     : factors_by(*input.method, *prepared, asked);
}

RadiositySolver make_system(const SystemInput& input, const StageProgress& progress) {
  require_all(input.rows);
  const auto factors = input.factors->get(progress);
  const std::shared_ptr<const ExchangeMatrix> matrix(factors, &factors->matrix);
  return with_file_context(input.file, [&] {
    return RadiositySolver(matrix, input.reflectivities.values,
                           {.solver = input.solver, .iterations = input.iterations, .until = input.until});
  });
}

RadiositySolution make_radiosities(const RadiositiesInput& input, const StageProgress& progress) {
  const auto factors = input.factors->get(progress);
  const auto prepared = input.prepared->get(progress);
  const Scene2& scene = prepared->scene;
  const ExchangeMatrix& matrix = factors->matrix;
  if (input.closed)
    require_closed(scene, *input.divided->get(progress), memory_allowed(input.memory),
                   telling("view factors", progress));
  if (input.method->info().guarantee != Guarantee::kExact)
    require_not_negative(matrix, scene.file, input.method->info().name);
  const auto shares = input.shares ? input.shares->get(progress) : nullptr;
  return scene_radiosities(*input.system->get(progress), scene,
                           shares ? std::span<const LightShares>(*shares) : std::span<const LightShares>(),
                           factors->report.notes, telling("radiosity", progress));
}

std::vector<LightShares> make_shares(const LightSharesInput& input, const StageProgress& progress) {
  return light_shares(*input.prepared->get(progress), input.granularity, input.test);
}

DividingEstimate make_dividing(const DividingInput& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto factors = input.factors->get(progress);
  const auto whole = input.whole->get(progress);
  const auto shares = input.shares ? input.shares->get(progress) : nullptr;
  return with_file_context(whole->scene.file, [&] {
    return estimate_dividing(
        {.whole = *whole,
         .solved = {whole->scene, factors->matrix, *radiosities,
                    shares ? std::span<const LightShares>(*shares) : std::span<const LightShares>()},
         .has_exact_factors = input.method->info().guarantee == Guarantee::kExact,
         .lights = input.test,
         .memory = memory_allowed(input.memory),
         .progress = telling("dividing", progress)});
  });
}

LightRows2 make_rows(const RowsInput& input, const StageProgress& progress) {
  const auto prepared = input.arrangement->get(progress);
  return with_file_context(prepared->scene.file, [&] {
    return LightRows2(*prepared, input.grid, *prepared->elements(input.granularity), Blacks2::kLeftOut,
                      memory_allowed(input.memory), telling("illumination", progress));
  });
}

IlluminationGrid2 light_of_rows(const LightRows2& rows, const LightInput& input, const PreparedScene2& prepared,
                                const RadiositySolution& solution) {
  const ElementTable2& table = *prepared.elements(input.granularity);
  return with_lights(prepared, illuminate_points(rows, input.grid, sent_out_2(table, solution, prepared.scene)));
}

SolvedLight2 make_light(const LightInput& input, const StageProgress& progress) {
  const auto radiosities = input.radiosities->get(progress);
  const auto prepared = input.prepared->get(progress);
  const auto rows = input.rows ? input.rows->get(progress) : nullptr;
  Stopwatch watch;
  SolvedLight2 light = with_file_context(prepared->scene.file, [&]() -> SolvedLight2 {
    if (rows) return {light_of_rows(*rows, input, *prepared, *radiosities)};
    return illuminate(input.kind, *prepared, input.grid, input.granularity, *radiosities,
                      telling("illumination", progress));
  });
  light.seconds = watch.lap();
  return light;
}

LightPicture2 make_picture(const PictureInput& input, const StageProgress& progress) {
  const auto light = input.light->get(progress);
  const auto prepared = input.prepared->get(progress);
  Stopwatch watch;
  LightPicture2 picture = input.painter->paint(*prepared, light->grid);
  picture.seconds = watch.lap();
  return picture;
}

SceneCheck2 make_check(const CheckInput& input, const StageProgress& progress) {
  return check_scene(*input.scene, {.prepared = [&] { return input.whole->get(progress); },
                                    .factors =
                                        [&] {
                                          const auto factors = input.exact_factors->get(progress);
                                          return std::shared_ptr<const ExchangeMatrix>(factors, &factors->matrix);
                                        },
                                    .lights = [&] { return *input.shares->get(progress); },
                                    .progress = telling("check", progress)});
}

// The exact method as the catalogue makes it: one object for all that ask for none.
const MethodPtr& exact_method() {
  static const MethodPtr method = methods_2().make("exact");
  return method;
}

// Whether a method is that one, or another object that does the same.
bool is_usual(const MethodPtr& method) {
  return !method || (method->info().name == exact_method()->info().name && !method->keeps_pairs_on_disk());
}

}  // namespace

namespace {

// An arrangement, and the scene that it was made with.
struct Arranged {
  StagePtr<PreparedScene2> stage;
  ScenePtr scene;
};

}  // namespace

struct Simulation2::Version {
  ScenePtr scene;
  SimulationRequest2 request;
  Grid2 grid;
  Granularity granularity = Granularity::kFace;

  StageNode<PlanInput, Plan> plan;
  StageNode<ArrangementInput, PreparedScene2> undivided;
  StageNode<DivisionInput, PreparedScene2> cut;  // where some surface is divided
  Arranged divided;                              // the undivided one where none is
  // With this scene: as rows are asked for, undivided, and divided.
  StageNode<PreparedInput, PreparedScene2> prepared, whole, parted;
  StageNode<FactorsInput, ComputedFactors2> factors, exact_factors;
  StageNode<SystemInput, RadiositySolver> system;
  StageNode<LightSharesInput, std::vector<LightShares>> shares, exact_shares;  // of factors, of exact_factors
  StageNode<RadiositiesInput, RadiositySolution> radiosities;
  StageNode<DividingInput, DividingEstimate> dividing;
  StageNode<RowsInput, LightRows2> rows;
  StageNode<LightInput, SolvedLight2> light;
  StageNode<PictureInput, LightPicture2> picture;
  StageNode<LostLightInput, Findings2> lost_light;
  StageNode<CheckInput, SceneCheck2> check;

  Version(ScenePtr its_scene, SimulationRequest2 its_request, const Version* before);

 private:
  Arranged arrangement() const;  // as rows are asked for
  PlanRequest plan_request() const;
  void set_arrangements(const Version* before);
  void set_factors(const Version* before);
  void set_light(const Version* before);
  void set_findings(const Version* before);
};

namespace {

// An arrangement with the scene of a version: itself where it was made for that scene.
StageNode<PreparedInput, PreparedScene2> with_values(const Arranged& arrangement, const ScenePtr& scene,
                                                     const StageNode<PreparedInput, PreparedScene2>* before) {
  const PreparedInput input{arrangement.stage, scene};
  if (arrangement.scene == scene) return {input, arrangement.stage};
  return node_of("arrangement", input, before, make_prepared);
}

}  // namespace

Simulation2::Version::Version(ScenePtr its_scene, SimulationRequest2 its_request, const Version* before)
    : scene(std::move(its_scene)), request(std::move(its_request)) {
  if (const std::string problem = request.grid ? grid_problem(*request.grid) : ""; !problem.empty())
    throw UsageError("the grid of a request: " + problem);
  const bool keeps_grid = before != nullptr && before->scene == scene && !before->request.grid;
  grid = request.grid ? *request.grid : keeps_grid ? before->grid : default_grid(*scene);
  granularity = request.granularity.value_or(is_divided(*scene) || request.everything ? Granularity::kElement
                                                                                      : Granularity::kFace);
  set_arrangements(before);
  plan = node_of("plan", PlanInput{parted.stage, plan_request()}, member_of(before, &Version::plan),
                 [](const PlanInput& input, const StageProgress& progress) {
                   return plan_scene(*input.prepared->get(progress), input.request);
                 });
  set_factors(before);
  set_light(before);
  set_findings(before);
}

PlanRequest Simulation2::Version::plan_request() const {
  PlanRequest result{.everything = request.everything,
                     .is_average = request.light == LightKind2::kAverage,
                     .has_picture = request.wants_picture};
  if (!request.wants_light) return result;
  const bool is_of_one = request.grid || scene->grids.empty();
  for (const Grid2& each : is_of_one ? std::vector{grid} : scene->grids) {
    result.grid_cells += each.cells();
    result.grid_pixels += picture_pixels_2(each);
  }
  return result;
}

void Simulation2::Version::set_arrangements(const Version* before) {
  undivided = node_of("arrangement", ArrangementInput{scene}, member_of(before, &Version::undivided), make_arrangement);
  const Arranged whole_surfaces{undivided.stage, undivided.input.scene};
  divided = whole_surfaces;
  if (is_divided(*scene)) {
    cut = node_of("arrangement", DivisionInput{undivided.stage, scene}, member_of(before, &Version::cut), make_divided);
    divided = {cut.stage, cut.input.scene};
  }
  prepared = with_values(arrangement(), scene, member_of(before, &Version::prepared));
  whole = with_values(whole_surfaces, scene, member_of(before, &Version::whole));
  parted = with_values(divided, scene, member_of(before, &Version::parted));
}

Arranged Simulation2::Version::arrangement() const {
  const bool tells_elements_apart =
      granularity == Granularity::kElement || (request.method && request.method->works_by_elements());
  return tells_elements_apart ? divided : Arranged{undivided.stage, undivided.input.scene};
}

void Simulation2::Version::set_factors(const Version* before) {
  const FactorsInput wanted{.arrangement = arrangement().stage,
                            .scene = scene,
                            .method = is_usual(request.method) ? exact_method() : request.method,
                            .granularity = granularity,
                            .rows = request.store ? RowChoice() : request.rows,  // what is kept is kept whole
                            .wants_visibility = request.wants_visibility,
                            .wants_measures = request.wants_measures,
                            .everything = request.everything,
                            .memory = request.memory,
                            .store = request.store};
  const FactorsInput exact{.arrangement = divided.stage,
                           .scene = scene,
                           .method = exact_method(),
                           .granularity = is_divided(*scene) ? Granularity::kElement : Granularity::kFace,
                           .memory = request.memory,
                           .store = request.store};
  factors = node_of("view factors", wanted, member_of(before, &Version::factors), make_factors);
  exact_factors = exact == wanted
                      ? factors
                      : node_of("view factors", exact, member_of(before, &Version::exact_factors), make_factors);
}

void Simulation2::Version::set_light(const Version* before) {
  system = node_of("radiosity",
                   SystemInput{factors.stage, factors.input.rows, Spectra{reflectivities_of(scene->materials)},
                               request.solver, request.iterations, request.until, scene->file},
                   member_of(before, &Version::system), make_system);
  const auto shares_of = [&](const auto& arranged, const auto& with_scene, Granularity of, LightTest by) {
    return LightSharesInput{arranged.stage, with_scene.stage, of, beams_of(scene->lights), scene->light_places, by};
  };
  const LightSharesInput wanted = shares_of(arrangement(), prepared, granularity, request.lights);
  const LightSharesInput exact = shares_of(divided, parted, exact_factors.input.granularity, LightTest::kExact);
  shares = node_of("lights", wanted, member_of(before, &Version::shares), make_shares);
  exact_shares =
      exact == wanted ? shares : node_of("lights", exact, member_of(before, &Version::exact_shares), make_shares);
  const RadiositiesInput to_solve{.system = system.stage,
                                  .factors = factors.stage,
                                  .method = factors.input.method,
                                  .prepared = prepared.stage,
                                  .emissions = emissions_of(*scene),
                                  .shares = scene->lights.empty() ? nullptr : shares.stage,
                                  .powers = powers_of(*scene),
                                  .closed = scene->closed,
                                  .divided = divided.stage,
                                  .memory = request.memory};
  radiosities = node_of("radiosity", to_solve, member_of(before, &Version::radiosities), make_radiosities);
  dividing = node_of("dividing",
                     DividingInput{radiosities.stage, factors.stage, factors.input.method, whole.stage, to_solve.shares,
                                   request.lights, request.memory},
                     member_of(before, &Version::dividing), make_dividing);
  rows = node_of("illumination", RowsInput{arrangement().stage, granularity, grid, request.memory},
                 member_of(before, &Version::rows), make_rows);
  const bool takes_rows = request.keeps_rows && request.light == LightKind2::kPoint;
  light = node_of("illumination",
                  LightInput{radiosities.stage, prepared.stage, granularity, grid, request.light,
                             takes_rows ? rows.stage : nullptr},
                  member_of(before, &Version::light), make_light);
  picture = node_of("picture", PictureInput{light.stage, prepared.stage, request.painter},
                    member_of(before, &Version::picture), make_picture);
}

void Simulation2::Version::set_findings(const Version* before) {
  lost_light = node_of("check", LostLightInput{prepared.stage, factors.stage}, member_of(before, &Version::lost_light),
                       [](const LostLightInput& input, const StageProgress& progress) {
                         const auto scene_there = input.prepared->get(progress);
                         return lost_light_warnings(*scene_there, input.factors->get(progress)->matrix);
                       });
  check = node_of("check", CheckInput{scene, whole.stage, exact_factors.stage, exact_shares.stage},
                  member_of(before, &Version::check), make_check);
}

Simulation2::Simulation2(ValidScene2 scene, SimulationRequest2 request)
    : version_(std::make_shared<const Version>(std::make_shared<const Scene2>(std::move(scene)), std::move(request),
                                               nullptr)) {}

Simulation2 Simulation2::with_scene(ValidScene2 scene) const {
  return Simulation2(std::make_shared<const Version>(std::make_shared<const Scene2>(std::move(scene)),
                                                     version_->request, version_.get()));
}

Simulation2 Simulation2::with_trees(std::vector<SurfaceTrees> trees) const {
  auto scene = std::make_shared<const Scene2>(hottel::with_trees(*version_->scene, std::move(trees)));
  for (const Surface& surface : scene->surfaces)
    for (const bool is_back : {false, true})
      if (const auto& leaves = surface.trees.of(is_back); !leaves.empty())
        HOTTEL_REQUIRE(are_whole(leaves, surface.elements, 2));
  return Simulation2(std::make_shared<const Version>(std::move(scene), version_->request, version_.get()));
}

Simulation2 Simulation2::with_request(SimulationRequest2 request) const {
  return Simulation2(std::make_shared<const Version>(version_->scene, std::move(request), version_.get()));
}

const Scene2& Simulation2::scene() const { return *version_->scene; }
const SimulationRequest2& Simulation2::request() const { return version_->request; }
const Grid2& Simulation2::grid() const { return version_->grid; }
Granularity Simulation2::granularity() const { return version_->granularity; }

std::shared_ptr<const Plan> Simulation2::plan(const StageProgress& progress) const {
  return version_->plan.stage->get(progress);
}
std::shared_ptr<const PreparedScene2> Simulation2::prepared(const StageProgress& progress) const {
  return version_->prepared.stage->get(progress);
}
void Simulation2::require_closed(const StageProgress& progress) const {
  if (!scene().closed) return;
  hottel::require_closed(scene(), *version_->divided.stage->get(progress), memory_allowed(version_->request.memory),
                         progress ? telling("view factors", progress) : nullptr);
}

std::shared_ptr<const ComputedFactors2> Simulation2::factors(const StageProgress& progress) const {
  return version_->factors.stage->get(progress);
}
std::shared_ptr<const RadiositySolver> Simulation2::system(const StageProgress& progress) const {
  return version_->system.stage->get(progress);
}
std::shared_ptr<const std::vector<LightShares>> Simulation2::light_shares(const StageProgress& progress) const {
  return version_->shares.stage->get(progress);
}
std::shared_ptr<const RadiositySolution> Simulation2::radiosities(const StageProgress& progress) const {
  return version_->radiosities.stage->get(progress);
}
std::shared_ptr<const DividingEstimate> Simulation2::dividing(const StageProgress& progress) const {
  return version_->dividing.stage->get(progress);
}
std::shared_ptr<const LightRows2> Simulation2::rows(const StageProgress& progress) const {
  return version_->rows.stage->get(progress);
}
std::shared_ptr<const SolvedLight2> Simulation2::light(const StageProgress& progress) const {
  return version_->light.stage->get(progress);
}
std::shared_ptr<const LightPicture2> Simulation2::picture(const StageProgress& progress) const {
  HOTTEL_REQUIRE(version_->request.painter != nullptr);
  return version_->picture.stage->get(progress);
}
std::shared_ptr<const Findings2> Simulation2::lost_light(const StageProgress& progress) const {
  return version_->lost_light.stage->get(progress);
}
std::shared_ptr<const SceneCheck2> Simulation2::check(const StageProgress& progress) const {
  return version_->check.stage->get(progress);
}

}  // namespace hottel
