// A scene while it is edited: its light is made in the background.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "geometry/plane/check/finding.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/support/stage.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel {

// How far the light of a scene is wanted, or has come.
enum class LiveDepth2 : unsigned char {
  kCoarse,  // on a grid of at most kCoarseCells cells: all else is as in kFull
  kFull,    // all of it, on the grid of `solve`
};
inline constexpr std::uint32_t kCoarseCells = 64 * 48;

// What is known of one version of the scene. Pointers are null where a stage failed, or those before it.
struct LiveState2 {
  std::uint64_t version = 0;
  LiveDepth2 depth = LiveDepth2::kCoarse;
  std::shared_ptr<const Scene2> scene;
  std::optional<Simulation2> simulation;  // nothing where the scene is none that a file can hold
  std::shared_ptr<const PreparedScene2> prepared;
  std::shared_ptr<const ComputedFactors2> factors;
  std::shared_ptr<const RadiositySolution> radiosities;
  std::shared_ptr<const SolvedLight2> light;
  std::string problem;  // why there is no light: one line; empty where there is
  Findings2 errors;     // what `check` calls errors, where there is no light
  double seconds = 0;   // from set() until it was there
};

// Returns a grid over the same region with at most so many cells, in about the same proportion; the grid itself where
// it has no more. REQUIRES most >= 1.
Grid2 coarse_grid_2(const Grid2& grid, std::uint32_t most);

// Makes the light of the version that was set last, on a thread of its own.
//
//   (1) once is_done(), state() is that of the last version, as far as it was asked for; where that is kFull, its
//       values are bit for bit those of a new simulation of the same scene and request
//   (2) a version is shown coarse first. One that is set meanwhile does not stop that, so that something new is shown
//       however fast versions follow; it stops what is done beyond
//   (3) only the last of the versions that wait is made
//   (4) a version whose depth is kCoarse is not made further until it is set again with kFull
//   (5) after light is full, what the cells see is kept (SimulationRequest2::keeps_rows): light after an edit of
//       materials needs no further look. Left out where memory does not suffice
//   (6) the destructor stops what runs, and waits for that
// changed: called on that thread after each new state; must be quick, and may ask state() alone. All functions may be
// called by any thread.
class LiveScene2 {
 public:
  explicit LiveScene2(SimulationRequest2 request, std::function<void()> changed = {});
  ~LiveScene2();
  LiveScene2(const LiveScene2&) = delete;
  LiveScene2& operator=(const LiveScene2&) = delete;

  // Returns the number of the version, counted from 1. The scene need not be valid.
  std::uint64_t set(std::shared_ptr<const Scene2> scene, LiveDepth2 depth);

  // The state that came last; before the first one, of version 0 without a scene.
  std::shared_ptr<const LiveState2> state() const;
  bool is_done() const;
  // Waits until the version that was set last has come as far as it was asked to, so many seconds at most. Returns
  // whether it has.
  bool wait(double seconds) const;

 private:
  struct Task {
    std::uint64_t version = 0;
    std::shared_ptr<const Scene2> scene;
    LiveDepth2 depth = LiveDepth2::kCoarse;
    Stopwatch since;
  };

  void run();
  void make(const Task& task);
  std::optional<Simulation2> simulation_of(const Task& task, LiveState2& state) const;
  bool make_light(const Simulation2& simulation, const StageProgress& progress, LiveState2& state) const;
  void explain(const Simulation2& simulation, const StageProgress& progress, LiveState2& state) const;
  void keep_rows();
  void publish(LiveState2 state, const Task& task);
  StageProgress until_stopped() const;
  StageProgress until_next_version() const;

  const SimulationRequest2 request_;
  const std::function<void()> changed_;
  std::optional<Simulation2> last_;  // of the thread alone: what the next version shares stages with

  mutable std::mutex mutex_;
  mutable std::condition_variable news_;
  std::optional<Task> waiting_;
  std::shared_ptr<const LiveState2> state_;
  std::uint64_t set_ = 0, done_ = 0;  // the last version set, and the last one made as far as it was asked
  std::atomic<bool> is_stopping_{false}, has_waiting_{false};
  std::thread thread_;
};

}  // namespace hottel
