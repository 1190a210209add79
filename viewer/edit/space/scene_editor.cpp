#include "viewer/edit/space/scene_editor.h"

#include <utility>

#include "kernel/support/failure.h"
#include "viewer/edit/light_list.h"

namespace hottel {

SceneEditor3::SceneEditor3(Scene3 scene, MayBe may_be, MayStand may_stand)
    : history_(std::move(scene)), may_be_(std::move(may_be)), may_stand_(std::move(may_stand)) {}

// Nothing is held any more.
void SceneEditor3::let_go() {
  held_.reset();
  grip_.reset();
  snapper_.reset();
}

void SceneEditor3::replace(std::shared_ptr<const Scene3> scene) {
  let_go();
  select_none();
  refusal_.clear();
  history_ = EditHistory<Scene3>(std::move(scene));
}

std::optional<LightHold> SceneEditor3::pick_light(const Pointer3& pointer) const {
  return hottel::pick_light(*scene(), pointer);
}

void SceneEditor3::select_light(std::uint32_t light) {
  HOTTEL_REQUIRE(light < scene()->lights.size());
  select_none();
  light_ = light;
}

// Selects what is called as it was in another scene.
void SceneEditor3::keep_selection(const Scene3& before) {
  corner_.reset();
  selected_ = selection_called_as(before, selected_, *scene());
  light_ = light_called_as(before, light_, *scene());
}

bool SceneEditor3::refuses(const Scene3& next, std::uint32_t light, const Point3* before) {
  refusal_ = may_be_(next, light, before);
  return !refusal_.empty();
}

bool SceneEditor3::press(const Pointer3& pointer) {
  let_go();
  held_ = pick_light(pointer);
  if (!held_) return false;
  refusal_.clear();
  const LightShape3 shape = *light_shape(*scene(), held_->light, pointer);
  const Pixel at = pointer.seen(held_->part == LightPart::kPlace  ? shape.place
                                : held_->part == LightPart::kAxis ? shape.axis
                                : held_->part == LightPart::kLeft ? shape.left
                                                                  : shape.right);
  offset_ = {at.x - pointer.at.x, at.y - pointer.at.y};
  select_light(held_->light);
  return true;
}

void SceneEditor3::drag(const Pointer3& pointer) {
  if (held_) drag_light(pointer);
  if (grip_) drag_grip(pointer);
}

void SceneEditor3::drag_light(const Pointer3& pointer) {
  if (!is_dragging()) history_.begin(std::string(verb_of(held_->part)) + " " + scene()->lights[held_->light].name);
  Pointer3 held = pointer;
  held.at = {pointer.at.x + offset_.x, pointer.at.y + offset_.y};
  const Scene3& before = *history_.scene_before_drag();
  Scene3 next = hottel::drag_light(before, *held_, held);
  const Point3 from = before.light_places[held_->light].position;
  if (held_->part == LightPart::kPlace && refuses(next, held_->light, &from)) return;
  history_.preview(std::move(next));
}

void SceneEditor3::release() {
  if (is_dragging()) {
    const Scene3& before = *history_.scene_before_drag();
    if (scene()->lights == before.lights && scene()->light_places == before.light_places &&
        scene()->polygons == before.polygons)
      return cancel();
    history_.commit();
  }
  let_go();
}

void SceneEditor3::cancel() {
  if (is_dragging()) history_.cancel();
  if (grip_ && grip_->is_corner) corner_ = grip_->anchor;
  let_go();
}

// To the scene before the last step, or to the one after it.
std::string SceneEditor3::go(bool is_back) {
  const std::shared_ptr<const Scene3> before = scene();
  const std::string what = is_back ? history_.what_undo() : history_.what_redo();
  if (!(is_back ? history_.undo() : history_.redo())) return "";
  let_go();
  keep_selection(*before);
  return (is_back ? "undone: " : "done again: ") + what;
}

std::string SceneEditor3::undo() {
  if (!is_dragging()) return go(true);
  cancel();
  return "drag dropped";
}

std::string SceneEditor3::redo() { return go(false); }

// What is held is of the scene before.
void SceneEditor3::set(Scene3 next, const std::string& what) {
  let_go();
  refusal_.clear();
  const std::shared_ptr<const Scene3> before = scene();
  history_.set(std::move(next), what);
  keep_selection(*before);
}

// Another scene, in which a light is selected. done, what: to it.
std::string SceneEditor3::set_light(Scene3 next, const std::string& done, const std::string& what,
                                    std::uint32_t light) {
  refusal_.clear();
  settle_bands(next);
  if (next.lights == scene()->lights && next.light_places == scene()->light_places) return "";
  const std::string name = next.lights[light].name;
  set(std::move(next), what + " " + name);
  select_light(light);
  return done + " " + name;
}

std::string SceneEditor3::move_to(const Point3& place) {
  const std::optional<Point3> from = place_of_selection();
  if (is_dragging() || !from) return "";
  if (!light_) return move_selection(place - *from);
  Scene3 next = move_light(*scene(), *light_, place - *from);
  if (refuses(next, *light_, &*from)) return "";
  return set_light(std::move(next), "moved", "move", *light_);
}

std::string SceneEditor3::rotate(const Rational& degrees, int axis, int decimals) {
  if (is_dragging()) return "";
  if (light_) return set_light(turn_light(*scene(), *light_, degrees), "turned", "turn", *light_);
  return turn_selection(degrees, axis, decimals);
}

std::string SceneEditor3::duplicate(const Vector3& way) {
  if (is_dragging()) return "";
  if (!light_) return copy_selection(way);
  const Point3 from = scene()->light_places[*light_].position;
  Scene3 next = copy_light(*scene(), *light_, move_light(*scene(), *light_, way).light_places[*light_]);
  const auto copy = static_cast<std::uint32_t>(scene()->lights.size());
  if (refuses(next, copy, &from)) return "";
  return set_light(std::move(next), "copied", "copy", copy);
}

std::string SceneEditor3::erase() {
  if (is_dragging()) return "";
  if (!light_) return erase_selection();
  const std::string name = scene()->lights[*light_].name;
  set(erase_light(*scene(), *light_), "delete " + name);
  return "deleted " + name;
}

std::string SceneEditor3::add_light(const Point3& place) {
  if (is_dragging()) return "";
  LightPlace3 where;
  where.position = place;
  Scene3 next = hottel::add_light(*scene(), std::move(where));
  const auto light = static_cast<std::uint32_t>(scene()->lights.size());
  if (refuses(next, light, nullptr)) return "";
  return set_light(std::move(next), "added", "add", light);
}

std::string SceneEditor3::change_light(std::uint32_t light, const Light& values, const Vector3& rotation) {
  if (is_dragging()) return "";
  return set_light(hottel::set_light(*scene(), light, values, rotation), "changed", "change", light);
}

std::string SceneEditor3::change_materials(std::vector<Material> materials, const std::string& what) {
  HOTTEL_REQUIRE(materials.size() == scene()->materials.size());
  if (is_dragging() || materials == scene()->materials) return "";
  Scene3 next = *scene();
  next.materials = std::move(materials);
  next.expect.clear();
  set(std::move(next), what);
  return what;
}

}  // namespace hottel
