#include "solver/space/simulation/simulation.h"

#include <algorithm>
#include <utility>

#include "geometry/closed_promise.h"
#include "geometry/space/exchange/closed_promise.h"
#include "geometry/space/scene/validation.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/radiosity_sources.h"
#include "solver/refinement.h"
#include "solver/space/simulation/stages.h"

namespace hottel {
namespace {

// Whether polygons, and what patches lie on, are the same.
bool has_places_of(const Scene3& a, const Scene3& b) {
  const auto is_alike = [](const Surface& s, const Surface& t) {
    return s.on == t.on && s.group == t.group && s.name == t.name;
  };
  return a.polygons == b.polygons && a.bases == b.bases && a.groups == b.groups &&
         std::ranges::equal(a.surfaces, b.surfaces, is_alike);
}

struct PictureInput3 {
  StagePtr<IlluminationGrid3> light;
  std::shared_ptr<const LightPainter3> painter;
  friend bool operator==(const PictureInput3&, const PictureInput3&) = default;
};

LightPicture3 make_picture(const PictureInput3& input, const StageProgress& progress) {
  const auto light = input.light->get(progress);
  Stopwatch watch;
  LightPicture3 result = input.painter->paint(*light);
  result.seconds = watch.lap();
  return result;
}

}  // namespace

struct Simulation3::Version {
  ScenePtr3 scene;
  SimulationRequest3 request;

  StageNode<ArrangementInput3, PreparedScene3> arranged;
  StageNode<PreparedInput3, PreparedScene3> prepared;  // with this scene
  StageNode<PlanInput3, Plan> plan;
  StageNode<FactorsInput3, ComputedFactors3> factors;
  StageNode<HiddenInput3, std::vector<ElementPair>> hidden;
  StageNode<LitInput3, LitElements3> lit;
  StageNode<LightSharesInput3, std::vector<LightShares>> shares;
  StageNode<SystemInput3, RadiositySolver> system;
  StageNode<RadiositiesInput3, RadiositySolution> radiosities;
  StageNode<DividingInput3, DividingEstimate> dividing;
  StageNode<LightInput3, IlluminationGrid3> light;
  StageNode<PictureInput3, LightPicture3> picture;

  Version(ScenePtr3 its_scene, const SimulationRequest3& its_request, const Version* before)
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
    arranged =
        node_of("preparation", ArrangementInput3{scene}, member_of(before, &Version::arranged), make_arrangement);
    const PreparedInput3 with_scene{arranged.stage, scene};
    if (arranged.input.scene == scene)
      prepared = {with_scene, arranged.stage};
    else
      prepared = node_of("preparation", with_scene, member_of(before, &Version::prepared), make_prepared);
    plan = node_of("plan", PlanInput3{prepared.stage, request.plan, request.factors.sky},
                   member_of(before, &Version::plan), make_plan);
  }

  // What was measured for the version before, where it holds for this scene unless that is refused.
  StagePtr<ComputedFactors3> measured(const Version* before) const {
    if (before == nullptr || !(before->request.factors == request.factors) || !is_same_shape(*before->scene, *scene) ||
        !is_divided_alike(*before->scene, *scene))
      return nullptr;
    const FactorsInput3& made = before->factors.input;
    return made.measured ? made.measured : before->factors.stage;
  }

  void set_factors(const Version* before) {
    const Granularity granularity = request.factors.granularity;
    factors =
        node_of("view factors", FactorsInput3{arranged.stage, scene, prepared.stage, request.factors, measured(before)},
                member_of(before, &Version::factors), make_factors);
    hidden = node_of("hidden pairs", HiddenInput3{factors.stage, prepared.stage, granularity, request.factors.rows},
                     member_of(before, &Version::hidden), make_hidden);
    lit = node_of("lights", LitInput3{arranged.stage, scene, prepared.stage, granularity},
                  member_of(before, &Version::lit), make_lit);
    shares = node_of("lights", LightSharesInput3{lit.stage, scene, prepared.stage, granularity, request.lights},
                     member_of(before, &Version::shares), make_shares);
  }

  void set_radiosities(const Version* before) {
    system = node_of("radiosity",
                     SystemInput3{factors.stage, request.factors, prepared.stage, scene,
                                  Spectra{reflectivities_of(scene->materials)}, request.system},
                     member_of(before, &Version::system), make_system);
    radiosities = node_of(
        "radiosity",
        RadiositiesInput3{system.stage, factors.stage, scene, emissions_of(*scene), shares.stage, powers_of(*scene)},
        member_of(before, &Version::radiosities), make_radiosities);
    dividing = node_of(
        "dividing",
        DividingInput3{radiosities.stage, factors.stage, prepared.stage, shares.stage, request.factors, request.lights},
        member_of(before, &Version::dividing), make_dividing);
  }

  void set_light(const Version* before) {
    light = node_of("illumination",
                    LightInput3{radiosities.stage, prepared.stage, grid(), request.factors, request.light.is_average},
                    member_of(before, &Version::light), make_light);
    picture = node_of("picture", PictureInput3{light.stage, request.light.painter},
                      member_of(before, &Version::picture), make_picture);
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
