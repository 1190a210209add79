#include "viewer/window/plane/scene_looks.h"

#include <chrono>
#include <thread>
#include <utility>

#include "kernel/support/stopwatch.h"

namespace hottel {

SceneLooks2::SceneLooks2(SimulationRequest2 request, const std::function<void()>& changed)
    : live_(std::move(request), changed), state_(live_.state()), looking_(changed), toning_(changed) {}

void SceneLooks2::set_scene(std::shared_ptr<const Scene2> scene, LiveDepth2 depth) {
  toning_.cancel();  // the next state asks for its own
  live_.set(std::move(scene), depth);
}

void SceneLooks2::set_request(const LookRequest2& request) {
  if (request == request_) return;
  LookRequest2 same_look = request_;
  same_look.mouse = request.mouse;
  same_look.other = request.other;
  if (!(same_look == request)) {  // what is there is of something else
    result_.reset();
    is_changed_ = true;
  }
  request_ = request;
  ask();
}

void SceneLooks2::set_tone(const ToneChoice& tone, std::uint32_t pixels_per_cell) {
  if (tone == tone_ && pixels_per_cell == pixels_per_cell_) return;
  const bool is_other_tone = !(tone == tone_);
  tone_ = tone;
  pixels_per_cell_ = pixels_per_cell;
  if (is_other_tone && texture_) set_first_texture(texture_->state);
  ask_for_fine_texture();
}

void SceneLooks2::set_first_texture(std::shared_ptr<const LiveState2> state) {
  Raster raster = first_texture_2(*state, tone_);
  texture_ = std::make_shared<const LightTexture2>(LightTexture2{std::move(state), tone_, 1, std::move(raster)});
  is_changed_ = true;
}

void SceneLooks2::look_again() {
  result_.reset();
  ask();
}

void SceneLooks2::ask() {
  if (!state_->scene || !needs_work(request_)) {
    looking_.cancel();
    is_changed_ = is_changed_ || result_;
    result_.reset();
    return;
  }
  looking_.post([this, state = state_, request = request_](const StageProgress& progress, const auto& tell) {
    const auto apply = [this](LookResult2 result) {
      return [this, result = std::make_shared<LookResult2>(std::move(result))] {
        result_ = std::move(*result);
        is_changed_ = true;
      };
    };
    return Background::Apply(
        apply(look_at(*state, request, progress, [&](LookResult2 so_far) { tell(apply(std::move(so_far))); })));
  });
}

void SceneLooks2::ask_for_fine_texture() {
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

bool SceneLooks2::collect() {
  looking_.collect();
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

bool SceneLooks2::is_at_rest() const {
  return live_.is_done() && live_.state() == state_ && !looking_.is_busy() && !toning_.is_busy();
}

bool SceneLooks2::wait(double seconds) {
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
