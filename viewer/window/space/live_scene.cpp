#include "viewer/window/space/live_scene.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

#include "kernel/support/interrupt.h"

namespace hottel {

LiveScene3::LiveScene3(SimulationRequest3 request, std::function<void()> changed)
    : request_(std::move(request)), changed_(std::move(changed)), preparing_(changed_), lighting_(changed_) {}

void LiveScene3::look_from(const Direction3& eye) {
  eye_ = eye;
  if (set_) set_->rows().look_from(eye);
}

void LiveScene3::set(std::shared_ptr<const Scene3> scene) {
  const bool is_same_shape = set_ && set_->has_shape_of(*scene);
  const bool keeps_factors = is_same_shape && are_alike_as_before_3(set_->scene()->materials, scene->materials);
  set_ = is_same_shape ? set_->with_scene(std::move(scene)) : SceneVersion3(std::move(scene), request_, changed_);
  set_->rows().look_from(eye_);
  if (!is_same_shape) state_ = {};
  since_ = {};
  is_changed_ = is_changed_ || !state_.is_lit();
  if (keeps_factors && state_.problem.empty()) {
    has_factors_ ? light_anew() : sweep_anew();
    return;
  }
  is_changed_ = true;
  lighting_.cancel();
  state_.problem.clear();
  prepare_anew();
}

// Light takes the place of none, not the other way round.
void LiveScene3::show(LiveVersion3::Ptr version) {
  if (state_.is_lit() && !version->is_lit()) return;
  state_.version = std::move(version);
  is_changed_ = true;
}

void LiveScene3::fail(const std::string& problem) {
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
  preparing_.post([this, version = *set_](const StageProgress& go_on, const Background::Tell& tell) {
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
      tell([this, first = LiveVersion3::first(version, progress)] { show(first); });
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
      return Background::Apply([this, problem = std::string(error.what())] { fail(problem); });
    }
  });
}

void LiveScene3::light_anew() {
  lighting_.follow([this, version = *set_, since = since_](const StageProgress& progress, const Background::Tell&) {
    try {
      return Background::Apply([this, lit = LiveVersion3::lit(version, since, progress)] {
        show(lit);
        state_.problem.clear();
      });
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      return Background::Apply([this, problem = std::string(error.what())] { fail(problem); });
    }
  });
}

// Sweeps over the rows that have come; before the first ones, the light before factors.
void LiveScene3::sweep_anew() {
  if (!state_.version || state_.is_lit() || has_factors_) return;
  lighting_.post([this, version = *set_, rows = rows_, from = state_.version](const StageProgress& progress,
                                                                              const Background::Tell& tell) {
    const auto apply = [this](LiveVersion3::Ptr next) { return [this, next = std::move(next)] { show(next); }; };
    if (!rows) return Background::Apply(apply(LiveVersion3::first(version, progress)));
    LiveVersion3::sweep(version, *rows, *from, progress, [&](LiveVersion3::Ptr next) { tell(apply(std::move(next))); });
    return Background::Apply();
  });
}

bool LiveScene3::collect() {
  preparing_.collect();
  if (auto rows = set_ ? set_->rows().take() : nullptr; rows && state_.version && !has_factors_) {
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
