// A scene in space while it is looked at: its light is made in the background.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/picture/space/smooth_mesh.h"
#include "viewer/window/background.h"
#include "viewer/window/space/nearest_rows.h"

namespace hottel {

// What is needed to look at a scene: its arrangement, its elements, and how values run over them.
struct LiveModel3 {
  PreparedScene3 prepared;
  ElementTable3 table;
  SmoothMesh3 mesh;

  explicit LiveModel3(const PreparedScene3& scene);
};

// What is known of the scene so far. Pointers are null where a stage failed, or has not come.
struct LiveState3 {
  std::shared_ptr<const LiveModel3> model;
  std::shared_ptr<const ComputedFactors3> factors;
  // Of the materials and lights in `lit`; of those before, while it is not done.
  std::shared_ptr<const RadiositySolution> radiosities;
  std::shared_ptr<const Scene3> lit;      // the scene that the light is of
  std::optional<Simulation3> simulation;  // of that
  std::optional<Simulation3> whole;       // the same asked for whole polygons: its factors are made when asked for
  // The light of the rows that have come, while others have not: after some sweeps. Nothing before the first, and of no
  // meaning once there are radiosities.
  std::optional<ElementPaint3> so_far;
  std::uint32_t rows = 0, all_rows = 0;  // that have come, of
  std::string stage;                     // what runs: "view factors 43 %"; empty at rest
  std::string problem;                   // why there is no light: one line; empty where there is
  double seconds = 0;                    // from set() until the light was there
};

// Makes the light of the scene that was set last, in the background. All functions are for one thread.
//
//   (1) at rest, radiosities are bit for bit those of a new simulation of the scene and the request
//   (2) what is needed to look at the scene comes first, then its factors, those of elements nearest to the eye first
//       (NearestRows3), and with them light that goes around among the rows that have come, then its light
//   (3) a scene that differs from the one before in materials and lights alone does not disturb the factors that are
//       there or on their way, nor the system where no reflectivity differs, unless other materials are alike than
//       before (are_alike_as_before_3). Its light follows that which is on its way: something new is shown however fast
//       scenes follow each other
//   (4) the destructor stops what runs, and waits for that
class LiveScene3 {
 public:
  // changed: called on other threads when there is something to collect; must be quick.
  LiveScene3(SimulationRequest3 request, const std::function<void()>& changed);

  // Throws InputError for a scene that is none (validate).
  void set(std::shared_ptr<const Scene3> scene);

  // Where the eye is: what is near comes first.
  void look_from(const Direction3& eye) { watch_->look_from(eye); }

  // Takes what has come. True where something has changed.
  bool collect();
  bool is_at_rest() const;
  // Collects until all is at rest, so many seconds at most. Returns whether it is.
  bool wait(double seconds);

  const LiveState3& state() const { return state_; }

 private:
  void prepare_anew();
  void light_anew();
  void sweep_anew();

  const std::shared_ptr<NearestRows3> watch_;
  SimulationRequest3 request_;
  std::shared_ptr<const Scene3> scene_;
  std::optional<Simulation3> simulation_;
  LiveState3 state_;
  Stopwatch since_;
  bool is_changed_ = false;
  std::shared_ptr<const RowsSoFar3> rows_;
  Background preparing_, lighting_;
};

// The light before there are factors: every face receives the mean of what a closed room of these materials holds, a
// little more from above, so that faces are told apart. [unit: that of emissions]
ElementPaint3 light_before_factors_3(const Scene3& scene, const ElementTable3& table);

}  // namespace hottel
