// A scene under a hand: what is selected, what is dragged, and what can be done to it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/scene/scene.h"
#include "viewer/edit/edit_history.h"
#include "viewer/edit/plane/light_handles.h"
#include "viewer/edit/plane/pick.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/edit/plane/snapping.h"
#include "viewer/edit/selection.h"

namespace hottel {

// Where a hand points, and how it holds.
struct Pointer2 {
  Place2 place{};
  double reach = 0;       // how near counts as touching [scene length]
  double arm = 0;         // how far from a light its handles are [scene length]
  int decimals = 2;       // of places where nothing is near (decimals_at)
  bool adds = false;      // what is touched is added to the selection, or taken out of it
  bool alone = false;     // what is touched parts from what coincides with it
  bool is_whole = false;  // an edge stands for its group
};

// Edits one scene.
//
//   (1) every edit is one step of the history; a drag is one, from press() to release(). What changes nothing is none
//   (2) a vertex that is dragged takes along every end that lies exactly there; `alone`, the nearest end by itself
//   (3) an edge that is dragged takes along what coincides with its ends. A selection of whole groups of several
//       surfaces moves by itself, at whichever vertex or edge it is held: furniture parts from the wall it stands at.
//       So does everything that is dragged `alone`
//   (4) a dragged thing is placed so that the vertex, or the edge's nearer end, at which it is held comes to lie on a
//       snapped place (Snapper2), of the scene in which the drag began
//   (5) the selection is kept by names: after undo, too, it is what is still there
//   (6) the scene may be invalid after an edit: it is shown, and undone or mended by the next edit
//   (7) lights are touched before edges are, wherever both are within reach; a light or surfaces are selected, not both
class SceneEditor2 {
 public:
  explicit SceneEditor2(Scene2 scene);

  const std::shared_ptr<const Scene2>& scene() const { return history_.scene(); }
  const EditHistory<Scene2>& history() const { return history_; }
  void mark_saved() { history_.mark_saved(); }
  // Counts everything that changed the scene.
  std::uint64_t version() const { return version_; }

  // Another scene takes the place of this one, without a history.
  void replace(Scene2 scene);

  // What lies under the pointer.
  Pick2 pick(const Pointer2& pointer) const;
  Snap2 snap(const Pointer2& pointer) const;
  std::optional<LightHold> pick_light(const Pointer2& pointer) const;

  // The surfaces that are selected, ascending, and the vertex, where one is.
  const Selection& selected() const { return selected_; }
  const std::optional<Point2>& selected_vertex() const { return vertex_; }
  const std::optional<std::uint32_t>& selected_light() const { return light_; }
  void select(Selection surfaces);
  void select_all();
  void select_none();
  void select_groups();  // all surfaces of the groups that something is selected of
  void select_in(const Place2& corner, const Place2& opposite, bool adds);

  // A button goes down: selects what is there. False where nothing is.
  bool press(const Pointer2& pointer);
  // The pointer moves with the button down, after press() found something. Nothing is held any more once anything else
  // has changed the scene.
  void drag(const Pointer2& pointer);
  void release();
  void cancel();
  bool is_dragging() const { return history_.is_dragging(); }

  // Each returns what was done, for a message; empty where there was nothing to do.
  std::string undo();
  std::string redo();
  std::string move_by(const Rational& dx, const Rational& dy);
  // The selected light or vertex, or the first end of the first selected surface, goes to this place; the rest goes
  // with it.
  std::string move_to(const Point2& place);
  std::string rotate(const Rational& degrees, int decimals);  // about the middle of the selection's box, or a light
  std::string duplicate(const Rational& dx, const Rational& dy);
  std::string erase();
  std::string reverse();
  std::string add_line(const std::vector<Point2>& points, bool closed, std::uint32_t material);
  std::string add_lamp(const Point2& centre, const Rational& half_size);
  std::string add_light(const Point2& place);

  // Gives a light other values and its axis another rotation.
  std::string change_light(std::uint32_t light, const Light& values, const Rational& rotation);

  // Changes the material of a face, for all that have it; copies_first: for the face's group alone. Nothing where the
  // face has none. change: what to do to it.
  std::string change_material(const Face& face, bool copies_first, const std::function<void(Material&)>& change);

 private:
  struct Held {
    std::uint32_t surface = 0;
    bool is_last = false, is_vertex = false, moves_alone = false;
    Point2 anchor;
    Place2 offset{};  // of the anchor from where it was touched
  };

  void changed();
  void set(Scene2 scene, const std::string& what);
  std::string set_light(Scene2 scene, const std::string& done, const std::string& what, std::uint32_t light);
  void select_light(std::uint32_t light);
  void hold_light(const Pointer2& pointer);
  void drag_light(const Pointer2& pointer);
  void set_selected_names(const Scene2& before, const Selection& surfaces);
  std::string go(bool is_back);
  bool is_of_whole_groups() const { return is_furniture(*scene(), selected_); }
  std::uint32_t surface_at(const Point2& vertex, std::uint32_t surface) const;
  Scene2 moved(const Scene2& scene, const Held& held, const Point2& to) const;
  std::vector<Point2> ends_of_selection(const Scene2& scene) const;
  std::vector<PointMove2> moves_of_selection(const Scene2& scene, const Rational& dx, const Rational& dy) const;
  std::vector<std::uint32_t> surfaces_that_move(const Scene2& scene, const Held& held) const;

  EditHistory<Scene2> history_;
  std::uint64_t version_ = 0;
  std::shared_ptr<const Scene2> picked_;  // what the picker was made of
  std::unique_ptr<ScenePick2> picker_;
  Selection selected_, selected_before_;  // before: of the scene before the drag
  std::optional<Point2> vertex_;
  std::optional<std::uint32_t> light_;
  std::optional<Held> held_;
  std::optional<LightHold> held_light_;
  Place2 light_offset_{};              // of what is held of a light from where it was touched
  std::unique_ptr<Snapper2> snapper_;  // of the scene before the drag
  std::vector<std::uint32_t> moving_;
};

}  // namespace hottel
