#include "viewer/window/space/live_version.h"

#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/stage_inputs.h"
#include "viewer/window/space/first_light.h"

namespace hottel {
namespace {

constexpr int kMostSweepsSoFar = 50;
constexpr double kLeastChange = 1e-3;  // of the largest radiosity

SimulationRequest3 watched_by(SimulationRequest3 request, const std::shared_ptr<NearestRows3>& rows) {
  request.factors.watch = rows;
  return request;
}

SimulationRequest3 of_whole_polygons(SimulationRequest3 request) {
  request.factors.granularity = Granularity::kFace;
  request.factors.watch = nullptr;
  return request;
}

}  // namespace

LiveModel3::LiveModel3(const PreparedScene3& scene)
    : prepared(scene), elements(prepared.elements(Granularity::kElement)), mesh(prepared, table()) {}

std::optional<std::uint32_t> LiveElement3::number_in(const LiveModel3& other) const {
  if (&other == model.get()) return number;
  const Element& its = element();
  for (std::uint32_t k = 0; k < other.table().count(); ++k) {
    const Element& there = other.table().elements()[k];
    if (there.name == its.name && there.parts == its.parts) return k;
  }
  return std::nullopt;
}

SceneVersion3::SceneVersion3(std::shared_ptr<const Scene3> scene, std::shared_ptr<NearestRows3> rows,
                             Simulation3 simulation, Simulation3 whole, ModelStage model)
    : scene_(std::move(scene)),
      rows_(std::move(rows)),
      simulation_(std::move(simulation)),
      whole_(std::move(whole)),
      model_(std::move(model)) {}

SceneVersion3::SceneVersion3(std::shared_ptr<const Scene3> scene, const SimulationRequest3& request,
                             const std::function<void()>& changed)
    : scene_(std::move(scene)),
      rows_(std::make_shared<NearestRows3>(changed)),
      simulation_(*scene_, watched_by(request, rows_)),
      whole_(simulation_.with_request(of_whole_polygons(request))),
      model_(model_of(simulation_)) {}

SceneVersion3::ModelStage SceneVersion3::model_of(const Simulation3& simulation) {
  return std::make_shared<Stage<LiveModel3>>("preparation", [simulation](const StageProgress& progress) {
    return LiveModel3(*simulation.prepared(progress));
  });
}

bool SceneVersion3::has_shape_of(const Scene3& other) const {
  return scene_->file == other.file && scene_->polygons == other.polygons && scene_->surfaces == other.surfaces &&
         scene_->materials.size() == other.materials.size() && scene_->groups == other.groups &&
         scene_->bases == other.bases && scene_->masks == other.masks && scene_->sky_emission == other.sky_emission &&
         scene_->closed == other.closed;
}

SceneVersion3 SceneVersion3::with_scene(std::shared_ptr<const Scene3> scene) const {
  HOTTEL_REQUIRE(has_shape_of(*scene));
  Simulation3 simulation = simulation_.with_scene(*scene);
  Simulation3 whole = whole_.with_scene(*scene);
  ModelStage model = are_alike_as_before(scene_->materials, scene->materials) ? model_ : model_of(simulation);
  return SceneVersion3(std::move(scene), rows_, std::move(simulation), std::move(whole), std::move(model));
}

LiveVersion3::Ptr LiveVersion3::first(const SceneVersion3& of, const StageProgress& progress,
                                      const LiveVersion3* before) {
  LiveVersion3 result(of, progress);
  result.light_ = light_before_factors_3(result.scene(), result.model().table());
  if (before != nullptr)
    carry_light_3({before->scene(), before->model().table(), before->light()}, result.scene(), result.model().table(),
                  result.light_);
  return std::make_shared<const LiveVersion3>(std::move(result));
}

LiveVersion3::Ptr LiveVersion3::lit(const SceneVersion3& of, const Stopwatch& since, const StageProgress& progress) {
  LiveVersion3 result(of, progress);
  result.factors_ = of.simulation().factors(progress);
  result.radiosities_ = of.simulation().radiosities(progress);
  result.light_ = light_paint_3(result.scene(), *result.radiosities_);
  result.seconds_ = Stopwatch(since).lap();
  return std::make_shared<const LiveVersion3>(std::move(result));
}

void LiveVersion3::sweep(const SceneVersion3& of, const RowsSoFar3& rows, const LiveVersion3& from,
                         const StageProgress& progress, const std::function<void(Ptr)>& tell) {
  const Ptr begin = first(of, progress);
  const bool goes_on =
      from.light().channels == begin->light().channels && from.light().values.size() == begin->light().values.size();
  RowSweeps3 sweeps(begin->scene(), begin->model().table(), rows, *of.simulation().light_shares(progress),
                    goes_on ? from.light() : begin->light());
  for (int k = 0; k < kMostSweepsSoFar; ++k) {
    progress("sweeps", static_cast<double>(k) / kMostSweepsSoFar);
    const bool is_last = sweeps.sweep() < kLeastChange;
    LiveVersion3 result(*begin);
    result.light_ = sweeps.light();
    tell(std::make_shared<const LiveVersion3>(std::move(result)));
    if (is_last) return;
  }
}

const std::shared_ptr<const ComputedFactors3>& LiveVersion3::factors() const {
  HOTTEL_REQUIRE(is_lit());
  return factors_;
}

const std::shared_ptr<const RadiositySolution>& LiveVersion3::radiosities() const {
  HOTTEL_REQUIRE(is_lit());
  return radiosities_;
}

}  // namespace hottel
