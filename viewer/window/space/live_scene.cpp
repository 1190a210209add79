#include "viewer/window/space/live_scene.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

#include "kernel/support/interrupt.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/stage_inputs.h"

namespace hottel {

namespace {

constexpr std::size_t kSoonLit = 200;  // polygons of which coarse light is there as soon as a frame of them is drawn

SimulationRequest3 coarse(SimulationRequest3 request, const std::string& method) {
  request.factors = {.granularity = Granularity::kElement};
  if (!method.empty()) request.factors.method = methods_3().make(method);
  return request;
}

Scene3 undivided(Scene3 scene) {
  for (Surface& surface : scene.surfaces) {
    surface.elements = 1;
    surface.trees = {};
  }
  return scene;
}

}  // namespace

std::string coarse_method_3(std::size_t polygons) {
  return polygons <= 64 ? "points:2" : polygons <= 1500 ? "points:1" : "";
}

LiveScene3::LiveScene3(SimulationRequest3 request, std::function<void()> changed)
    : request_(std::move(request)), changed_(std::move(changed)), preparing_(changed_), lighting_(changed_) {}

void LiveScene3::look_from(const Direction3& eye) {
  eye_ = eye;
  if (set_) set_->rows().look_from(eye);
}

void LiveScene3::set(std::shared_ptr<const Scene3> scene, LiveDepth3 depth) {
  if (depth == LiveDepth3::kCoarse) return set_coarse(std::move(scene));
  const bool is_same_shape = set_ && set_->has_shape_of(*scene);
  const bool keeps_factors = is_same_shape && are_alike_as_before(set_->scene()->materials, scene->materials);
  set_ = is_same_shape ? set_->with_scene(std::move(scene)) : SceneVersion3(std::move(scene), request_, changed_);
  set_->rows().look_from(eye_);
  since_ = {};
  const bool was_coarse = std::exchange(is_coarse_, false);
  if (!is_same_shape || was_coarse) begin_shape();
  is_changed_ = is_changed_ || !state_.is_lit();
  if (keeps_factors && state_.problem.empty() && (has_factors_ || !was_coarse)) {
    has_factors_ ? light_anew() : sweep_anew();
    return;
  }
  is_changed_ = true;
  state_.problem.clear();
  lighting_.cancel();
  prepare_anew();
}

void LiveScene3::forget() {
  if (state_.version && set_ && set_->has_shape_of(state_.version->scene())) return;
  state_.version = nullptr;
  state_.is_coarse = false;
  is_changed_ = true;
}

// What runs for another shape is not wanted any more.
void LiveScene3::begin_shape() {
  ++shape_;
  state_.stage.clear();
  state_.problem.clear();
  state_.rows = state_.all_rows = 0;
  preparing_.cancel();
  is_changed_ = true;
}

void LiveScene3::set_coarse(std::shared_ptr<const Scene3> scene) {
  if (!std::exchange(is_coarse_, true)) {
    preparing_.cancel();
    lighting_.cancel();
    state_.stage.clear();
  }
  ++shape_;
  preparing_.follow([this, scene = std::move(scene), before = state_.version, shape = shape_, since = Stopwatch()](
                        const StageProgress& progress, const Background::Tell& tell) {
    try {
      const std::string method = coarse_method_3(scene->polygons.size());
      const SceneVersion3 version(std::make_shared<const Scene3>(undivided(*scene)), coarse(request_, method),
                                  changed_);
      const auto show_it = [this, shape](LiveVersion3::Ptr next) {
        return [this, shape, next = std::move(next)] { show(next, shape, true); };
      };
      LiveVersion3::Ptr first = LiveVersion3::first(version, progress, before.get());
      if (method.empty()) return Background::Apply(show_it(std::move(first)));
      if (scene->polygons.size() > kSoonLit) tell(show_it(std::move(first)));
      return Background::Apply(show_it(LiveVersion3::lit(version, since, progress)));
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      return Background::Apply([this, shape, problem = std::string(error.what())] { fail(problem, shape); });
    }
  });
}

// Of one shape light takes the place of none, not the other way round.
void LiveScene3::show(LiveVersion3::Ptr version, std::uint64_t shape, bool is_coarse) {
  if (shape < shown_) return;
  if (shape == shown_ && state_.is_lit() && !version->is_lit()) return;
  shown_ = shape;
  state_.version = std::move(version);
  state_.is_coarse = is_coarse;
  if (is_coarse) state_.problem.clear();
  is_changed_ = true;
}

void LiveScene3::fail(const std::string& problem, std::uint64_t shape) {
  if (shape < shape_ && !is_coarse_) return;
  state_.problem = problem;
  state_.stage.clear();
  is_changed_ = true;
}

// A tenth of a second between what is told of what runs.
void LiveScene3::prepare_anew() {
  has_factors_ = false;
  set_->rows().take();  // of the factors before
  rows_ = nullptr;
  state_.rows = state_.all_rows = 0;
  preparing_.post([this, version = *set_, before = state_.version, shape = shape_](const StageProgress& go_on,
                                                                                   const Background::Tell& tell) {
    const auto say = [this](const std::string& stage) {
      return [this, stage] {
        state_.stage = stage;
        is_changed_ = true;
      };
    };
    std::string told;
    const StageProgress progress = [&](std::string_view stage, double fraction) {
      go_on(stage, fraction);
      std::string text = fmt::format("{} {:.0f} %", stage, 100 * fraction);
      if (text != told) tell(say(text));
      told = std::move(text);
    };
    try {
      tell(say("preparation"));
      tell([this, shape, first = LiveVersion3::first(version, progress, before.get())] { show(first, shape); });
      version.simulation().factors(progress);
      return Background::Apply([this] {
        has_factors_ = true;
        state_.stage.clear();
        lighting_.cancel();  // sweeps
        light_anew();
      });
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      return Background::Apply([this, shape, problem = std::string(error.what())] { fail(problem, shape); });
    }
  });
}

void LiveScene3::light_anew() {
  lighting_.follow(
      [this, version = *set_, since = since_, shape = shape_](const StageProgress& progress, const Background::Tell&) {
        try {
          return Background::Apply([this, shape, lit = LiveVersion3::lit(version, since, progress)] {
            show(lit, shape);
            state_.problem.clear();
          });
        } catch (const Interrupted&) {
          throw;
        } catch (const std::exception& error) {
          return Background::Apply([this, shape, problem = std::string(error.what())] { fail(problem, shape); });
        }
      });
}

// Sweeps over the rows that have come; before the first ones, the light before factors.
void LiveScene3::sweep_anew() {
  if (!state_.version || state_.is_lit() || has_factors_) return;
  lighting_.post([this, version = *set_, rows = rows_, from = state_.version, shape = shape_](
                     const StageProgress& progress, const Background::Tell& tell) {
    const auto apply = [this, shape](LiveVersion3::Ptr next) {
      return [this, shape, next = std::move(next)] { show(next, shape); };
    };
    if (!rows) return Background::Apply(apply(LiveVersion3::first(version, progress)));
    LiveVersion3::sweep(version, *rows, *from, progress, [&](LiveVersion3::Ptr next) { tell(apply(std::move(next))); });
    return Background::Apply();
  });
}

bool LiveScene3::collect() {
  preparing_.collect();
  if (auto rows = set_ ? set_->rows().take() : nullptr; rows && state_.version && !has_factors_ && !is_coarse_) {
    rows_ = std::move(rows);
    state_.rows = rows_->count;
    state_.all_rows = rows_->all;
    is_changed_ = true;
    sweep_anew();
  }
  lighting_.collect();
  return std::exchange(is_changed_, false);
}

bool LiveScene3::is_at_rest() const { return !preparing_.is_busy() && !lighting_.is_busy(); }

bool LiveScene3::wait(double seconds) {
  Stopwatch watch;
  bool has_changed = false;
  for (double waited = 0; waited < seconds; waited += watch.lap()) {
    has_changed = collect() || has_changed;
    if (is_at_rest()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  is_changed_ = has_changed || is_changed_;
  return is_at_rest();
}

}  // namespace hottel
