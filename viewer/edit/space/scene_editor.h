// A scene in space under a hand: which light is selected, what is dragged, and what can be done to it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/edit/edit_history.h"
#include "viewer/edit/space/light_handles.h"

namespace hottel {

// Edits the lights and materials of one scene.
//
//   (1) every edit is one step of the history; a drag is one, from press() to release(). What changes nothing is none
//   (2) a light never comes to where it may not be: it stays where it was, and refusal() says why
//   (3) the selection is kept by its name: after undo, too, it is what is still there
class SceneEditor3 {
 public:
  // Says why a light may not be where it is in a scene, and empty where it may; before: where it was, null where it is
  // new.
  using MayBe = std::function<std::string(const Scene3& scene, std::uint32_t light, const Point3* before)>;

  SceneEditor3(Scene3 scene, MayBe may_be);

  const std::shared_ptr<const Scene3>& scene() const { return history_.scene(); }
  const EditHistory<Scene3>& history() const { return history_; }
  void mark_saved() { history_.mark_saved(); }
  // Why the last edit was refused; empty where it was not.
  const std::string& refusal() const { return refusal_; }

  // Another scene takes the place of this one, without a history.
  void replace(std::shared_ptr<const Scene3> scene);

  std::optional<LightHold> pick_light(const Pointer3& pointer) const;
  const std::optional<std::uint32_t>& selected_light() const { return light_; }
  void select_light(std::uint32_t light);
  void select_none() { light_.reset(); }

  // A button goes down: selects the light that is there. False where none is.
  bool press(const Pointer3& pointer);
  // The pointer moves with the button down, after press() found something. Nothing is held any more once anything else
  // has changed the scene.
  void drag(const Pointer3& pointer);
  void release();
  void cancel();
  bool is_dragging() const { return history_.is_dragging(); }

  // Each returns what was done, for a message; empty where there was nothing to do, or it was refused.
  std::string undo();
  std::string redo();
  // Of the selected light.
  std::string move_to(const Point3& place);
  std::string rotate(const Rational& degrees);
  std::string duplicate(const Vector3& way);
  std::string erase();
  std::string add_light(const Point3& place);
  // Gives a light other values and its axis another rotation.
  std::string change_light(std::uint32_t light, const Light& values, const Vector3& rotation);
  // Takes materials in place of those of the scene. what: "change white". REQUIRES as many.
  std::string change_materials(std::vector<Material> materials, const std::string& what);

 private:
  bool refuses(const Scene3& scene, std::uint32_t light, const Point3* before);
  std::string set_light(Scene3 next, const std::string& done, const std::string& what, std::uint32_t light);
  void set(Scene3 next, const std::string& what);
  void keep_selection(const Scene3& before);

  EditHistory<Scene3> history_;
  MayBe may_be_;
  std::string refusal_;
  std::optional<std::uint32_t> light_;
  std::optional<LightHold> held_;
  Pixel offset_{};  // of what is held from where it was touched
};

}  // namespace hottel
