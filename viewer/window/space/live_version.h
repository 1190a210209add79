// One version of a scene in space, and all that is shown of it: never of two.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "geometry/element.h"
#include "geometry/face.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "kernel/support/stage.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/picture/space/smooth_mesh.h"
#include "viewer/window/space/nearest_rows.h"

namespace hottel {

// What is needed to look at a scene: its arrangement, its elements, and how values run over them. Of versions that are
// arranged alike it is one; the materials in `prepared` are those of one of them.
struct LiveModel3 {
  PreparedScene3 prepared;
  std::shared_ptr<const ElementTable3> elements;
  SmoothMesh3 mesh;

  explicit LiveModel3(const PreparedScene3& scene);
  const ElementTable3& table() const { return *elements; }
};

// An element, by its number in the model that it was found in.
struct LiveElement3 {
  std::shared_ptr<const LiveModel3> model;
  std::uint32_t number = 0;

  const Element& element() const { return model->table().elements()[number]; }
  Face face() const { return {element().surface, element().is_back}; }
  // Its number in another model; nothing where that has no such part of such a face. COST: linear, but in its own.
  std::optional<std::uint32_t> number_in(const LiveModel3& other) const;
};

// A scene as it was set, with what is asked of it. It never changes; copies are one version.
//
//   (1) all that can be had from it is of its scene
//   (2) versions of one shape share what Simulation3 shares, and the rows that have come; those that are arranged alike
//       (are_alike_as_before) the model too
class SceneVersion3 {
 public:
  // changed: called on other threads when rows have come. Throws InputError for a scene that is none (validate).
  SceneVersion3(std::shared_ptr<const Scene3> scene, const SimulationRequest3& request,
                const std::function<void()>& changed);
  // Whether another scene differs in materials and lights alone, and has as many materials.
  bool has_shape_of(const Scene3& other) const;
  // The version of another scene of its shape. Throws as the constructor does.
  SceneVersion3 with_scene(std::shared_ptr<const Scene3> scene) const;

  const std::shared_ptr<const Scene3>& scene() const { return scene_; }
  const Simulation3& simulation() const { return simulation_; }
  // The same asked for whole polygons: its factors are made when they are asked for.
  const Simulation3& whole() const { return whole_; }
  NearestRows3& rows() const { return *rows_; }
  // Made at the first call. Throws as the simulation's prepared().
  std::shared_ptr<const LiveModel3> model(const StageProgress& progress) const { return model_->get(progress); }

 private:
  using ModelStage = std::shared_ptr<Stage<LiveModel3>>;
  SceneVersion3(std::shared_ptr<const Scene3> scene, std::shared_ptr<NearestRows3> rows, Simulation3 simulation,
                Simulation3 whole, ModelStage model);
  static ModelStage model_of(const Simulation3& simulation);

  std::shared_ptr<const Scene3> scene_;
  std::shared_ptr<NearestRows3> rows_;
  Simulation3 simulation_, whole_;
  ModelStage model_;
};

// What is shown of a version: its model and its light, made of that version alone. It never changes, and threads share
// it: whoever draws, points or computes takes one of these, and nothing beside it.
class LiveVersion3 {
 public:
  using Ptr = std::shared_ptr<const LiveVersion3>;

  // Before there are factors: light_before_factors_3, and on faces that another version has too the light that they had
  // there (carry_light_3). before: that version; null: none. These throw what the stages throw.
  static Ptr first(const SceneVersion3& of, const StageProgress& progress, const LiveVersion3* before = nullptr);
  // With its light. since: from then on its seconds are counted.
  static Ptr lit(const SceneVersion3& of, const Stopwatch& since, const StageProgress& progress);
  // Calls tell with light that goes around among the rows that have come, after each sweep, until next to nothing
  // changes. from: light to begin with, taken where it has as many elements and channels. REQUIRES rows of its shape.
  static void sweep(const SceneVersion3& of, const RowsSoFar3& rows, const LiveVersion3& from,
                    const StageProgress& progress, const std::function<void(Ptr)>& tell);

  const SceneVersion3& of() const { return of_; }
  const Scene3& scene() const { return *of_.scene(); }
  const LiveModel3& model() const { return *model_; }
  const std::shared_ptr<const LiveModel3>& shared_model() const { return model_; }
  // As far as it is known.
  const ElementPaint3& light() const { return light_; }
  // Whether it has factors and radiosities, which the next two REQUIRE.
  bool is_lit() const { return radiosities_ != nullptr; }
  const std::shared_ptr<const ComputedFactors3>& factors() const;
  const std::shared_ptr<const RadiositySolution>& radiosities() const;
  double seconds() const { return seconds_; }  // until the light was there

 private:
  LiveVersion3(const SceneVersion3& of, const StageProgress& progress) : of_(of), model_(of.model(progress)) {}

  SceneVersion3 of_;
  std::shared_ptr<const LiveModel3> model_;
  ElementPaint3 light_;
  std::shared_ptr<const ComputedFactors3> factors_;
  std::shared_ptr<const RadiositySolution> radiosities_;
  double seconds_ = 0;
};

}  // namespace hottel
