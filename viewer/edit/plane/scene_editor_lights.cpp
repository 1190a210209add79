// What a scene editor does to lights.
#include "kernel/support/failure.h"
#include "viewer/edit/light_list.h"
#include "viewer/edit/plane/scene_editor.h"

namespace hottel {

std::optional<LightHold> SceneEditor2::pick_light(const Pointer2& pointer) const {
  return hottel::pick_light(*scene(), pointer.place, pointer.reach, pointer.arm);
}

void SceneEditor2::select_light(std::uint32_t light) {
  HOTTEL_REQUIRE(light < scene()->lights.size());
  select_none();
  light_ = light;
}

void SceneEditor2::hold_light(const Pointer2& pointer) {
  const LightShape2 shape = light_shape(*scene(), held_light_->light, pointer.arm);
  const Place2& at = held_light_->part == LightPart::kPlace  ? shape.place
                     : held_light_->part == LightPart::kAxis ? shape.axis
                     : held_light_->part == LightPart::kLeft ? shape.left
                                                             : shape.right;
  light_offset_ = {at[0] - pointer.place[0], at[1] - pointer.place[1]};
  select_light(held_light_->light);
}

void SceneEditor2::drag_light(const Pointer2& pointer) {
  if (!is_dragging()) {
    const std::string& name = scene()->lights[held_light_->light].name;
    history_.begin(std::string(verb_of(held_light_->part)) + " " + name);
    selected_before_ = selected_;
  }
  const Place2 to{pointer.place[0] + light_offset_[0], pointer.place[1] + light_offset_[1]};
  history_.preview(hottel::drag_light(*history_.scene_before_drag(), *held_light_, to, pointer.decimals));
  changed();
}

// Another scene, in which a light is selected. done, what: to it.
std::string SceneEditor2::set_light(Scene2 next, const std::string& done, const std::string& what,
                                    std::uint32_t light) {
  settle_bands(next);
  if (next.lights == scene()->lights && next.light_places == scene()->light_places) return "";
  const std::string name = next.lights[light].name;
  set(std::move(next), what + " " + name);
  select_light(light);
  return done + " " + name;
}

std::string SceneEditor2::add_light(const Point2& place) {
  if (is_dragging()) return "";
  return set_light(hottel::add_light(*scene(), {.position = place}), "added", "add",
                   static_cast<std::uint32_t>(scene()->lights.size()));
}

std::string SceneEditor2::change_light(std::uint32_t light, const Light& values, const Rational& rotation) {
  if (is_dragging()) return "";
  return set_light(hottel::set_light(*scene(), light, values, rotation), "changed", "change", light);
}

}  // namespace hottel
