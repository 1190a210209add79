// What a viewer does to lights, and how it draws them.
#include <utility>

#include "geometry/plane/scene/moving_lights.h"
#include "kernel/support/failure.h"
#include "viewer/edit/light_edits.h"
#include "viewer/window/lights.h"
#include "viewer/window/plane/viewer.h"

namespace hottel {

// The light under the mouse; where no edge is there either, the one that is selected.
std::optional<std::uint32_t> Viewer2::light_meant() const {
  if (hover_light_) return hover_light_->light;
  return hover_.surface ? std::nullopt : editor_.selected_light();
}

bool Viewer2::light_command(std::string_view name) {
  if (name == "play") {
    play();
    return true;
  }
  if (name != "material" && !is_light_edit(name)) return false;
  const std::optional<std::uint32_t> light = light_meant();
  if (!light && name == "spin") message_ = "no light lies under the mouse, and none is selected";
  if (!light) return name == "spin";
  name == "material" ? ask_for_light(*light) : change_light(*light, name);
  return true;
}

// Lights begin to move, or stand again where the scene has them.
void Viewer2::play() {
  if (time_)
    stop();
  else
    message_ = begin_to_move(time_, editor_.is_dragging(), has_moving_lights(*editor_.scene()));
}

void Viewer2::stop() {
  time_.reset();
  moved_.reset();
  views_.set_scene(editor_.scene(), LiveDepth2::kFull);
  needs_frame_ = true;
  message_ = "the lights stand";
}

bool Viewer2::pass_time(const Rational& seconds) {
  if (!time_) return false;
  *time_ += seconds;
  if (seconds > 0 && views_.is_at_rest()) move_lights();
  return true;
}

// Shows the lights at their time, as far as they may be there.
void Viewer2::move_lights() {
  needs_frame_ = true;
  auto moved = std::make_shared<const Scene2>(scene_after(*editor_.scene(), *time_));
  std::string problem = has_moving_lights(*editor_.scene()) ? "" : "no light moves";
  try {
    validate(*moved);
  } catch (const InputError& error) {
    problem = error.what();
  }
  if (!problem.empty()) {
    const std::string why = why_lights_stand(*time_, problem);
    stop();
    message_ = why;
    return;
  }
  moved_ = std::move(moved);
  views_.set_scene(moved_, LiveDepth2::kCoarse);
}

void Viewer2::change_light(std::uint32_t light, std::string_view name) {
  const std::string changed = editor_.change_light(light, [name](Light& values, Rational& rotation) {
    edit_light(values, {&rotation, 1}, name);
  });
  const Light& now = editor_.scene()->lights[light];
  const Rational& rotation = editor_.scene()->light_places[light].rotation;
  if (name == "spin" && !changed.empty() && !time_ && rotation != 0) time_ = 0;
  if (changed.empty())
    message_ = why_light_stays(name);
  else if (!hover_light_)  // what lies under the mouse is told already
    message_ = now.name + ": " + light_text(now, {&rotation, 1});
}

void Viewer2::ask_for_light(std::uint32_t light) {
  prompt_ = light_prompt(editor_.scene()->lights[light], {editor_.scene()->light_places[light].rotation},
                         [this, light](const Light& values, std::span<const Rational> rotation) {
                           editor_.change_light(light, [&](Light& changed, Rational& turning) {
                             changed = values;
                             turning = rotation[0];
                           });
                           scene_changed();
                         });
}

void Viewer2::draw_lights(PictureCanvas& canvas) const {
  const Scene2& scene = *shown_scene();
  for (std::uint32_t k = 0; k < scene.lights.size(); ++k) {
    if (scene.lights[k].is_sun()) continue;  // it is nowhere
    const LightShape2 shape = light_shape(scene, k, pointer().arm);
    LightMark mark{.place = camera_.at(shape.place, size_)};
    if (shape.is_spot) {
      mark.axis = camera_.at(shape.axis, size_);
      mark.left = camera_.at(shape.left, size_);
      mark.right = camera_.at(shape.right, size_);
    }
    LightStyle style{.is_meant = editor_.selected_light() == k};
    if (drag_ == Drag::kNone && hover_light_ && hover_light_->light == k) {
      style.is_meant = true;
      style.touched = hover_light_->part;
    }
    draw_light(canvas, scene.lights[k], mark, style, unit_);
  }
}

}  // namespace hottel
