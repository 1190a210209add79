#include "viewer/window/plane/scene_views.h"

#include <chrono>
#include <thread>
#include <utility>

#include "kernel/support/stopwatch.h"

namespace hottel {

SceneViews2::SceneViews2(SimulationRequest2 request, const std::function<void()>& changed)
    : live_(std::move(request), changed), state_(live_.state()), computing_(changed), toning_(changed) {}

void SceneViews2::set_scene(std::shared_ptr<const Scene2> scene, LiveDepth2 depth) {
  toning_.cancel();  // the next state asks for its own
  live_.set(std::move(scene), depth);
}

void SceneViews2::set_request(const ViewRequest2& request) {
  if (request == request_) return;
  ViewRequest2 same_mode = request_;
  same_mode.mouse = request.mouse;
  same_mode.other = request.other;
  if (!(same_mode == request)) {  // what is there is of something else
    result_.reset();
    is_changed_ = true;
  }
  request_ = request;
  ask();
}

void SceneViews2::set_tone(const ToneChoice& tone, std::uint32_t pixels_per_cell) {
  if (tone == tone_ && pixels_per_cell == pixels_per_cell_) return;
  const bool is_other_tone = !(tone == tone_);
  tone_ = tone;
  pixels_per_cell_ = pixels_per_cell;
  if (is_other_tone && texture_) set_first_texture(texture_->state);
  ask_for_fine_texture();
}

void SceneViews2::set_first_texture(std::shared_ptr<const LiveState2> state) {
  Raster raster = first_texture_2(*state, tone_);
  texture_ = std::make_shared<const LightTexture2>(LightTexture2{std::move(state), tone_, 1, std::move(raster)});
  is_changed_ = true;
}

void SceneViews2::compute_again() {
  result_.reset();
  ask();
}

void SceneViews2::ask() {
  if (!state_->scene || !needs_work(request_)) {
    computing_.cancel();
    is_changed_ = is_changed_ || result_;
    result_.reset();
    return;
  }
  computing_.post([this, state = state_, request = request_](const StageProgress& progress, const auto& tell) {
    const auto apply = [this](ViewResult2 result) {
      return [this, result = std::make_shared<ViewResult2>(std::move(result))] {
        result_ = std::move(*result);
        is_changed_ = true;
      };
    };
    return Background::Apply(
        apply(compute_view(*state, request, progress, [&](ViewResult2 so_far) { tell(apply(std::move(so_far))); })));
  });
}

void SceneViews2::ask_for_fine_texture() {
  const bool is_wanted = texture_ && texture_->state == state_ && state_->depth == LiveDepth2::kFull &&
                         texture_->pixels_per_cell != pixels_per_cell_;
  if (!is_wanted) {
    toning_.cancel();
    return;
  }
  toning_.post([this, state = state_, tone = tone_, pixels = pixels_per_cell_](const StageProgress&, const auto&) {
    auto texture = std::make_shared<const LightTexture2>(
        LightTexture2{state, tone, pixels, light_texture_2(*state, tone, pixels)});
    return Background::Apply([this, texture] {
      texture_ = texture;
      is_changed_ = true;
    });
  });
}

bool SceneViews2::collect() {
  computing_.collect();
  toning_.collect();
  if (const auto state = live_.state(); state != state_ && state->scene) {
    state_ = state;
    if (state_->light) set_first_texture(state_);
    is_changed_ = true;
    ask_for_fine_texture();
    ask();
  }
  return std::exchange(is_changed_, false);
}

bool SceneViews2::is_at_rest() const {
  return live_.is_done() && live_.state() == state_ && !computing_.is_busy() && !toning_.is_busy();
}

bool SceneViews2::wait(double seconds) {
  Stopwatch watch;
  bool has_changed = false;
  for (double waited = 0; waited < seconds; waited += watch.lap()) {
    live_.wait(seconds - waited);
    has_changed = collect() || has_changed;
    if (is_at_rest()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  is_changed_ = has_changed;
  return is_at_rest();
}

}  // namespace hottel
