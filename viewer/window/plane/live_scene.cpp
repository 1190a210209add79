#include "viewer/window/plane/live_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/light/light_values.h"

namespace hottel {

Grid2 coarse_grid_2(const Grid2& grid, std::uint32_t most) {
  HOTTEL_REQUIRE(most >= 1);
  Grid2 coarse = grid;
  for (std::uint32_t step = 1; std::uint64_t{coarse.nx} * coarse.ny > most; ++step) {
    coarse.nx = (grid.nx + step - 1) / step;
    coarse.ny = (grid.ny + step - 1) / step;
  }
  return coarse;
}

LiveScene2::LiveScene2(SimulationRequest2 request, std::function<void()> changed)
    : request_(std::move(request)),
      changed_(std::move(changed)),
      state_(std::make_shared<const LiveState2>()),
      thread_([this] { run(); }) {}

LiveScene2::~LiveScene2() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
  }
  news_.notify_all();
  thread_.join();
}

std::uint64_t LiveScene2::set(std::shared_ptr<const Scene2> scene, LiveDepth2 depth) {
  const std::lock_guard lock(mutex_);
  waiting_ = Task{++set_, std::move(scene), depth, {}};
  has_waiting_ = true;
  news_.notify_all();
  return set_;
}

std::shared_ptr<const LiveState2> LiveScene2::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

bool LiveScene2::is_done() const {
  const std::lock_guard lock(mutex_);
  return done_ == set_;
}

bool LiveScene2::wait(double seconds) const {
  std::unique_lock lock(mutex_);
  return news_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return done_ == set_; });
}

StageProgress LiveScene2::until_stopped() const {
  return [this](std::string_view, double) {
    if (is_stopping_) throw Interrupted();
  };
}

StageProgress LiveScene2::until_next_version() const {
  return [this](std::string_view, double) {
    if (is_stopping_ || has_waiting_) throw Interrupted();
  };
}

void LiveScene2::run() {
  for (;;) {
    Task task;
    {
      std::unique_lock lock(mutex_);
      news_.wait(lock, [this] { return is_stopping_ || waiting_; });
      if (is_stopping_) return;
      task = *std::exchange(waiting_, std::nullopt);
      has_waiting_ = false;
    }
    try {
      make(task);
      keep_rows();
    } catch (const Interrupted&) {
      if (interrupted()) return;  // the program is told to stop
    }
  }
}

void LiveScene2::make(const Task& task) {
  LiveState2 state;
  state.version = task.version;
  state.scene = task.scene;
  const std::optional<Simulation2> simulation = simulation_of(task, state);
  if (!simulation) {
    state.depth = task.depth;
    publish(std::move(state), task);
    return;
  }
  SimulationRequest2 coarse = simulation->request();
  coarse.grid = coarse_grid_2(simulation->grid(), kCoarseCells);
  const bool is_full = coarse.keeps_rows || coarse.grid == simulation->grid();
  const Simulation2 shown = is_full ? *simulation : simulation->with_request(coarse);
  last_ = *simulation;
  const bool has_light = make_light(shown, until_stopped(), state);
  state.depth = is_full || !has_light ? task.depth : LiveDepth2::kCoarse;
  const bool is_more_wanted = state.depth != task.depth;
  publish(state, task);
  if (!is_more_wanted) return;
  make_light(*simulation, until_next_version(), state);
  state.depth = LiveDepth2::kFull;
  publish(std::move(state), task);
}

// The version as a simulation that shares what it can with the one before; what is wrong with a scene that is none.
std::optional<Simulation2> LiveScene2::simulation_of(const Task& task, LiveState2& state) const {
  try {
    if (!last_) return Simulation2(*task.scene, request_);
    SimulationRequest2 request = request_;
    const Scene2& before = last_->scene();
    request.keeps_rows =
        last_->request().keeps_rows && before.edges == task.scene->edges && before.surfaces == task.scene->surfaces;
    return last_->with_scene(*task.scene).with_request(std::move(request));
  } catch (const InputError& error) {
    state.problem = error.what();
  }
  return std::nullopt;
}

// Fills the state stage by stage. False, and the problem told, where some stage failed.
bool LiveScene2::make_light(const Simulation2& simulation, const StageProgress& progress, LiveState2& state) const {
  state.simulation = simulation;
  state.light = nullptr;
  try {
    state.prepared = simulation.prepared(progress);
    state.factors = simulation.factors(progress);
    state.radiosities = simulation.radiosities(progress);
    state.light = simulation.light(progress);
    return true;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    state.problem = error.what();
  }
  explain(simulation, progress, state);
  return false;
}

void LiveScene2::explain(const Simulation2& simulation, const StageProgress& progress, LiveState2& state) const {
  try {
    const auto check = simulation.check(progress);
    for (const Finding2& finding : check->findings)
      if (finding.severity == Severity::kError) state.errors.push_back(finding);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {  // the problem is told already
  }
}

// What the cells see depends on no material: the next version has it where only materials change.
void LiveScene2::keep_rows() {
  if (!last_ || !state()->light || state()->depth != LiveDepth2::kFull) return;
  SimulationRequest2 request = last_->request();
  request.keeps_rows = true;
  Simulation2 with_rows = last_->with_request(request);
  try {
    with_rows.rows(until_next_version());
  } catch (const RequestError&) {
    return;  // they do not fit into memory
  }
  last_ = std::move(with_rows);
}

void LiveScene2::publish(LiveState2 state, const Task& task) {
  state.seconds = Stopwatch(task.since).lap();
  {
    const std::lock_guard lock(mutex_);
    if (state.depth == task.depth) done_ = task.version;
    state_ = std::make_shared<const LiveState2>(std::move(state));
  }
  news_.notify_all();
  if (changed_) changed_();
}

}  // namespace hottel
