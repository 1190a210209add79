#include "solver/plane/simulation/simulation.h"

#include <utility>

#include "geometry/plane/exchange/closed_promise.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/scene_plan.h"
#include "solver/plane/simulation/stages.h"
#include "solver/radiosity/radiosity_sources.h"
#include "solver/refinement.h"

namespace hottel {
namespace {

// The exact method as the catalogue makes it: one object for all that ask for none.
const MethodPtr2& exact_method() {
  static const MethodPtr2 method = methods_2().make("exact");
  return method;
}

// Whether a method is that one, or another object that does the same.
bool is_usual(const MethodPtr2& method) {
  return !method || (method->info().name == exact_method()->info().name && !method->keeps_pairs_on_disk());
}

struct PictureInput2 {
  StagePtr<SolvedLight2> light;
  StagePtr<PreparedScene2> prepared;  // not compared, as before
  std::shared_ptr<const LightPainter2> painter;
  friend bool operator==(const PictureInput2& a, const PictureInput2& b) {
    return a.light == b.light && a.painter == b.painter;
  }
};

LightPicture2 make_picture(const PictureInput2& input, const StageProgress& progress) {
  const auto light = input.light->get(progress);
  const auto prepared = input.prepared->get(progress);
  Stopwatch watch;
  LightPicture2 picture = input.painter->paint(*prepared, light->grid);
  picture.seconds = watch.lap();
  return picture;
}

// An arrangement, and the scene that it was made with.
struct Arranged {
  StagePtr<PreparedScene2> stage;
  ScenePtr2 scene;
};

}  // namespace

struct Simulation2::Version {
  ScenePtr2 scene;
  SimulationRequest2 request;
  Grid2 grid;
  Granularity granularity = Granularity::kFace;

  StageNode<PlanInput2, Plan> plan;
  StageNode<ArrangementInput2, PreparedScene2> undivided;
  StageNode<DivisionInput2, PreparedScene2> cut;  // where some surface is divided
  Arranged divided;                               // the undivided one where none is
  // With this scene: as rows are asked for, undivided, and divided.
  StageNode<PreparedInput2, PreparedScene2> prepared, whole, parted;
  StageNode<FactorsInput2, ComputedFactors2> factors, exact_factors;
  StageNode<SystemInput2, RadiositySolver> system;
  StageNode<LightSharesInput2, std::vector<LightShares>> shares, exact_shares;  // of factors, of exact_factors
  StageNode<RadiositiesInput2, RadiositySolution> radiosities;
  StageNode<DividingInput2, DividingEstimate> dividing;
  StageNode<RowsInput2, LightRows2> rows;
  StageNode<LightInput2, SolvedLight2> light;
  StageNode<PictureInput2, LightPicture2> picture;
  StageNode<LostLightInput2, Findings2> lost_light;
  StageNode<CheckInput2, SceneCheck2> check;

  Version(ScenePtr2 its_scene, SimulationRequest2 its_request, const Version* before);

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
StageNode<PreparedInput2, PreparedScene2> with_values(const Arranged& arrangement, const ScenePtr2& scene,
                                                      const StageNode<PreparedInput2, PreparedScene2>* before) {
  const PreparedInput2 input{arrangement.stage, scene};
  if (arrangement.scene == scene) return {input, arrangement.stage};
  return node_of("arrangement", input, before, make_prepared);
}

}  // namespace

Simulation2::Version::Version(ScenePtr2 its_scene, SimulationRequest2 its_request, const Version* before)
    : scene(std::move(its_scene)), request(std::move(its_request)) {
  if (const std::string problem = request.grid ? grid_problem(*request.grid) : ""; !problem.empty())
    throw UsageError("the grid of a request: " + problem);
  const bool keeps_grid = before != nullptr && before->scene == scene && !before->request.grid;
  grid = request.grid ? *request.grid : keeps_grid ? before->grid : default_grid(*scene);
  granularity = request.granularity.value_or(is_divided(*scene) || request.everything ? Granularity::kElement
                                                                                      : Granularity::kFace);
  set_arrangements(before);
  plan = node_of("plan", PlanInput2{parted.stage, plan_request()}, member_of(before, &Version::plan), make_plan);
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
  undivided =
      node_of("arrangement", ArrangementInput2{scene}, member_of(before, &Version::undivided), make_arrangement);
  const Arranged whole_surfaces{undivided.stage, undivided.input.scene};
  divided = whole_surfaces;
  if (is_divided(*scene)) {
    cut =
        node_of("arrangement", DivisionInput2{undivided.stage, scene}, member_of(before, &Version::cut), make_divided);
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
  const FactorsInput2 wanted{.arrangement = arrangement().stage,
                             .scene = scene,
                             .method = is_usual(request.method) ? exact_method() : request.method,
                             .granularity = granularity,
                             .rows = request.store ? RowChoice() : request.rows,  // what is kept is kept whole
                             .wants_visibility = request.wants_visibility,
                             .wants_measures = request.wants_measures,
                             .everything = request.everything,
                             .memory = request.memory,
                             .store = request.store};
  const FactorsInput2 exact{.arrangement = divided.stage,
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
                   SystemInput2{factors.stage, factors.input.rows, Spectra{reflectivities_of(scene->materials)},
                                request.system, scene->file},
                   member_of(before, &Version::system), make_system);
  const auto shares_of = [&](const auto& arranged, const auto& with_scene, Granularity of, LightTest by) {
    return LightSharesInput2{arranged.stage, with_scene.stage, of, beams_of(scene->lights), scene->light_places, by};
  };
  const LightSharesInput2 wanted = shares_of(arrangement(), prepared, granularity, request.lights);
  const LightSharesInput2 exact = shares_of(divided, parted, exact_factors.input.granularity, LightTest::kExact);
  shares = node_of("lights", wanted, member_of(before, &Version::shares), make_shares);
  exact_shares =
      exact == wanted ? shares : node_of("lights", exact, member_of(before, &Version::exact_shares), make_shares);
  const RadiositiesInput2 to_solve{.system = system.stage,
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
                     DividingInput2{radiosities.stage, factors.stage, factors.input.method, whole.stage,
                                    to_solve.shares, request.lights, request.memory},
                     member_of(before, &Version::dividing), make_dividing);
  rows = node_of("illumination", RowsInput2{arrangement().stage, granularity, grid, request.memory},
                 member_of(before, &Version::rows), make_rows);
  const bool takes_rows = request.keeps_rows && request.light == LightKind2::kPoint;
  light = node_of("illumination",
                  LightInput2{radiosities.stage, prepared.stage, granularity, grid, request.light,
                              takes_rows ? rows.stage : nullptr},
                  member_of(before, &Version::light), make_light);
  picture = node_of("picture", PictureInput2{light.stage, prepared.stage, request.painter},
                    member_of(before, &Version::picture), make_picture);
}

void Simulation2::Version::set_findings(const Version* before) {
  lost_light = node_of("check", LostLightInput2{prepared.stage, factors.stage}, member_of(before, &Version::lost_light),
                       make_lost_light);
  check = node_of("check", CheckInput2{scene, whole.stage, exact_factors.stage, exact_shares.stage},
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
