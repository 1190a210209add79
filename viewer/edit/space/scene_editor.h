// A scene in space under a hand: what is selected, what is dragged, and what can be done to it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/edit/edit_history.h"
#include "viewer/edit/selection.h"
#include "viewer/edit/space/light_handles.h"
#include "viewer/edit/space/pick.h"
#include "viewer/edit/space/scene_edits.h"
#include "viewer/edit/space/snapping.h"

namespace hottel {

// Edits one scene.
//
//   (1) every edit is one step of the history; a drag is one, from press() or grab() to release(). What changes nothing
//       is none
//   (2) a light never comes to where it may not be: it stays where it was, and refusal() says why. Neither does what is
//       no scene come about (edit_problem): a polygon that is not plane or crosses itself, a patch beside its base, a
//       light on a surface
//   (3) the selection is kept by names: after undo, too, it is what is still there. A light or surfaces are selected,
//       not both
//   (4) corners that are dragged take along all that lie exactly there; polygons stretch, and stay plane, patches on
//       what they lie on: where that leaves a plane or a line to go, the corners stay in it (planes_to_keep). A
//       selection of whole groups of several polygons moves by itself, and so does what is dragged `alone`
//   (5) what is dragged is placed so that the corner at which it is held, of a polygon the nearest one, comes to lie on
//       a snapped place (Snapper3), of the scene in which the drag began
class SceneEditor3 {
 public:
  // Says why a light may not be where it is in a scene, and empty where it may; before: where it was, null where it is
  // new.
  using MayBe = std::function<std::string(const Scene3& scene, std::uint32_t light, const Point3* before)>;
  // Says why an edited scene may not be so, though it is one; empty where it may.
  using MayStand = std::function<std::string(const Scene3& edited)>;

  SceneEditor3(Scene3 scene, MayBe may_be, MayStand may_stand = {});

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
  // What the ray of the mouse meets first.
  std::optional<Pick3> pick(const Pointer3& pointer) const;
  // The surfaces that are selected, ascending, and the corner, where one is.
  const Selection& selected() const { return selected_; }
  const std::optional<Point3>& selected_corner() const { return corner_; }
  void select(Selection surfaces);
  void select_groups();                    // all surfaces of the groups that something is selected of
  void toggle(const Selection& surfaces);  // into the selection, or where the first is of it, out of it
  void select_none() { select({}); }

  // A button goes down: selects the light that is there. False where none is.
  bool press(const Pointer3& pointer);
  // A button goes down: takes hold of what is selected, where a corner of it or itself is there. False where neither
  // is. is_there: what is seen there, where that is known better than by pick().
  bool grab(const Pointer3& pointer, const std::optional<Face>& is_there = {});
  // From now on what is grabbed goes along x, y or z (0, 1, 2), as far as it may; again: no longer.
  void toggle_axis(int axis);
  // The pointer moves with the button down, after press() or grab() found something. Nothing is held any more once
  // anything else has changed the scene.
  void drag(const Pointer3& pointer);
  void release();
  void cancel();
  bool is_dragging() const { return history_.is_dragging(); }

  // Each returns what was done, for a message; empty where there was nothing to do, or it was refused.
  std::string undo();
  std::string redo();
  // Where the selected light is, the selected corner, or the first corner of the first selected surface; nothing where
  // nothing is selected.
  std::optional<Point3> place_of_selection() const;
  // That goes there; the rest goes with it, as in (4).
  std::string move_to(const Point3& place);
  // About an axis (0, 1, 2): the selected light, about z, or the selected surfaces, about the middle of their box
  // (rotate_surfaces).
  std::string rotate(const Rational& degrees, int axis = 2, int decimals = 6);
  std::string duplicate(const Vector3& way);
  std::string erase();
  std::string reverse();
  std::string add_light(const Point3& place);
  // As add_box and add_rectangle, but for corners that are none of those.
  std::string add_box(const Point3& corner, const Point3& opposite, std::uint32_t material);
  std::string add_rectangle(const Point3& corner, const Point3& opposite, bool looks_back, std::uint32_t material);
  // Gives a light other values and its axis another rotation.
  std::string change_light(std::uint32_t light, const Light& values, const Vector3& rotation);
  // Takes materials in place of those of the scene. what: "change white". REQUIRES as many.
  std::string change_materials(std::vector<Material> materials, const std::string& what);

 private:
  struct Grip {
    Point3 anchor;
    bool is_corner = false, is_alone = false;
    std::uint32_t surface = 0;
    std::optional<int> axis{};
  };

  bool refuses(const Scene3& scene, std::uint32_t light, const Point3* before);
  bool refuses(const Scene3& before, const Scene3& edited);
  std::string set_light(Scene3 next, const std::string& done, const std::string& what, std::uint32_t light);
  std::string set_polygons(Scene3 next, const std::string& done, const std::string& what);
  void set(Scene3 next, const std::string& what);
  void let_go();
  void keep_selection(const Scene3& before);
  std::string go(bool is_back);
  bool is_of_whole_groups() const { return is_furniture(*scene(), selected_); }
  std::optional<std::uint32_t> selected_there(const Pointer3& pointer, const std::optional<Face>& is_there) const;
  std::optional<Grip> grip_at(const Pointer3& pointer, const std::optional<Face>& is_there) const;
  std::string text_of_selection() const;
  Corners3 corners_of_selection(const Scene3& scene) const;
  Freedom3 freedom(const Scene3& scene, const Pointer3& pointer) const;
  Scene3 moved(const Scene3& scene, const Vector3& way) const;
  void drag_light(const Pointer3& pointer);
  void drag_grip(const Pointer3& pointer);
  void begin_drag();
  std::string move_selection(const Vector3& way);
  std::string turn_selection(const Rational& degrees, int axis, int decimals);
  std::string copy_selection(const Vector3& way);
  std::string erase_selection();
  std::string add(AddedSurfaces3 added);

  EditHistory<Scene3> history_;
  MayBe may_be_;
  MayStand may_stand_;
  std::string refusal_;
  std::optional<std::uint32_t> light_;
  Selection selected_;
  std::optional<Point3> corner_;
  std::optional<LightHold> held_;
  std::optional<Grip> grip_;
  std::unique_ptr<Snapper3> snapper_;      // while a grip is dragged
  std::shared_ptr<const Scene3> dragged_;  // that it is of
  Pixel offset_{};                         // of what is held from where it was touched
  mutable std::shared_ptr<const Scene3> picked_;
  mutable std::unique_ptr<ScenePick3> picker_;  // of that scene
};

}  // namespace hottel
