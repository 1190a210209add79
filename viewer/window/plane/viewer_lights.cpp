// What a viewer does to lights, and how it draws them.
#include <utility>

#include "geometry/plane/scene/moving_lights.h"
#include "kernel/support/failure.h"
#include "viewer/window/lights.h"
#include "viewer/window/plane/viewer.h"

namespace hottel {

// The light under the mouse; where no edge is there either, the one that is selected.
std::optional<std::uint32_t> Viewer2::light_meant() {
  if (hover_light_) return hover_light_->light;
  return hover_.surface ? std::nullopt : editor_.selected_light();
}

std::vector<Rational> Viewer2::rotation_of(std::uint32_t light) const {
  return {editor_.scene()->light_places[light].rotation};
}

std::string Viewer2::set_light(std::uint32_t light, const Light& values, std::span<const Rational> rotation) {
  return editor_.change_light(light, values, rotation[0]);
}

bool Viewer2::can_lights_move() const { return has_moving_lights(*editor_.scene()); }

std::string Viewer2::show_lights_after(const Rational& seconds) {
  auto moved = std::make_shared<const Scene2>(scene_after(*editor_.scene(), seconds));
  try {
    validate(*moved);
  } catch (const InputError& error) {
    return error.what();
  }
  moved_ = std::move(moved);
  views_.set_scene(moved_, LiveDepth2::kCoarse);
  return "";
}

void Viewer2::show_lights_standing() {
  moved_.reset();
  views_.set_scene(editor_.scene(), LiveDepth2::kFull);
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
    const LightStyle style =
        light_style(k, editor_.selected_light(), drag_ == Drag::kNone ? hover_light_ : std::nullopt);
    draw_light(canvas, scene.lights[k], mark, style, unit_);
  }
}

}  // namespace hottel
