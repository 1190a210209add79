// A scene in space while it is looked at: its light is made in the background.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/direction.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/window/background.h"
#include "viewer/window/space/live_version.h"
#include "viewer/window/space/nearest_rows.h"

namespace hottel {

// How far the light of a scene is wanted.
enum class LiveDepth3 : unsigned char {
  kCoarse,  // of whole polygons, factors from a few points of each; of very many polygons the light of before alone
  kFull,    // all of it, as `solve` has it
};

// The method of coarse factors of so many polygons, the finest that is there soon: "points:2", of more than 64
// "points:1", of more than 1500 none (""): then there are no coarse factors.
std::string coarse_method_3(std::size_t polygons);

// What there is to be looked at, and what runs.
struct LiveState3 {
  // The last version that can be shown: with its light, once there has been one of its shape. Null where there is none
  // yet. Of another shape than that which was set last until there is something to be seen of that.
  LiveVersion3::Ptr version;
  bool is_coarse = false;                // the version is of kCoarse: an estimate, and no polygon is divided
  std::uint32_t rows = 0, all_rows = 0;  // that have come, of
  std::string stage;                     // what runs: "view factors 43 %"; empty at rest
  std::string problem;                   // why the scene that was set last has no light: one line; empty where it has

  // Whether the version shown has its light.
  bool is_lit() const { return version && version->is_lit(); }
};

// Makes the light of the scene that was set last, in the background. All functions are for one thread.
//
//   (1) at rest, the version is that of the scene set last, and its radiosities are bit for bit those of a new
//       simulation of the scene and the request; where it has no light, the problem says why
//   (2) what is needed to look at the scene comes first, then its factors, those of elements nearest to the eye first
//       (NearestRows3), and with them light that goes around among the rows that have come, then its light
//   (3) a scene that differs from the one before in materials and lights alone does not disturb the factors that are
//       there or on their way, nor the system where no reflectivity differs, unless other materials are alike than
//       before (are_alike_as_before). Its light follows that which is on its way: something new is shown however fast
//       scenes follow each other. Until it is there the version before stays, whole
//   (4) a scene of another shape is seen in the light of the one before, face by face, until there is more. One of
//       kCoarse follows that which is on its way, and goes no further until it is set again with kFull; what was known
//       in full of the shape set in full before stays known
//   (5) the destructor stops what runs, and waits for that
class LiveScene3 {
 public:
  // changed: called on other threads when there is something to collect; must be quick.
  LiveScene3(SimulationRequest3 request, std::function<void()> changed);

  // Throws InputError for a scene that is none (validate); of kCoarse that is its problem.
  void set(std::shared_ptr<const Scene3> scene, LiveDepth3 depth = LiveDepth3::kFull);

  // Shows nothing of another shape than that of the scene that was set last.
  void forget();

  // Where the eye is: what is near comes first.
  void look_from(const Direction3& eye);

  // Takes what has come. True where something has changed.
  bool collect();
  bool is_at_rest() const;
  // Collects until all is at rest, so many seconds at most. Returns whether it is.
  bool wait(double seconds);

  const LiveState3& state() const { return state_; }

 private:
  void set_coarse(std::shared_ptr<const Scene3> scene);
  void begin_shape();
  void prepare_anew();
  void light_anew();
  void sweep_anew();
  void show(LiveVersion3::Ptr version, std::uint64_t shape, bool is_coarse = false);
  void fail(const std::string& problem, std::uint64_t shape);

  const SimulationRequest3 request_;
  const std::function<void()> changed_;
  Direction3 eye_;
  std::optional<SceneVersion3> set_;  // the last
  bool has_factors_ = false;
  std::shared_ptr<const RowsSoFar3> rows_;  // of its shape
  LiveState3 state_;
  std::uint64_t shape_ = 0, shown_ = 0;  // counts the shapes that were set; of the version that is shown
  bool is_coarse_ = false;               // what was set last
  Stopwatch since_;
  bool is_changed_ = false;
  Background preparing_, lighting_;
};

}  // namespace hottel
