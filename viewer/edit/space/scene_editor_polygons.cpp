// What an editor of a scene in space does to polygons.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernel/support/failure.h"
#include "viewer/edit/space/scene_editor.h"

namespace hottel {
namespace {

Point3 plus(const Point3& p, const Vector3& way) { return {p.x + way.x, p.y + way.y, p.z + way.z}; }

// The middle of the box around some surfaces.
Point3 middle_of(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  Point3 low = scene.polygons[surfaces.front()].points.front(), high = low;
  for (const std::uint32_t s : surfaces)
    for (const Point3& p : scene.polygons[s].points)
      for (Rational Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
        low.*axis = std::min(low.*axis, p.*axis);
        high.*axis = std::max(high.*axis, p.*axis);
      }
  return {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
}

}  // namespace

std::optional<Pick3> SceneEditor3::pick(const Pointer3& pointer) const {
  if (picked_ != scene()) {
    picker_ = std::make_unique<ScenePick3>(*scene());
    picked_ = scene();
  }
  return picker_->at(pointer);
}

void SceneEditor3::select(Selection surfaces) {
  for (const std::uint32_t s : surfaces) HOTTEL_REQUIRE(s < scene()->surfaces.size());
  selected_ = selection_of(std::move(surfaces));
  corner_.reset();
  light_.reset();
}

void SceneEditor3::select_groups() { select(whole_groups(*scene(), selected_)); }

void SceneEditor3::toggle(const Selection& surfaces) {
  if (!surfaces.empty()) select(toggled(selected_, surfaces.front(), surfaces));
}

// "the box", "floor", "3 polygons".
std::string SceneEditor3::text_of_selection() const {
  if (corner_) return "a corner";
  if (selected_.size() == 1) return scene()->surfaces[selected_.front()].name;
  const std::uint32_t group = scene()->surfaces[selected_.front()].group;
  const bool is_one =
      std::ranges::all_of(selected_, [&](std::uint32_t s) { return scene()->surfaces[s].group == group; });
  return is_one && is_of_whole_groups() ? scene()->groups[group].name : std::to_string(selected_.size()) + " polygons";
}

bool SceneEditor3::refuses(const Scene3& before, const Scene3& edited) {
  refusal_ = edit_problem(before, edited);
  if (refusal_.empty() && may_stand_) refusal_ = may_stand_(edited);
  return !refusal_.empty();
}

// Another scene, unless it may not be. done, what: to what is selected.
std::string SceneEditor3::set_polygons(Scene3 next, const std::string& done, const std::string& what) {
  if (refuses(*scene(), next)) return "";
  if (next.polygons == scene()->polygons && next.surfaces == scene()->surfaces) return "";
  const std::string its = text_of_selection();
  set(std::move(next), what + " " + its);
  return done + " " + its;
}

std::optional<Point3> SceneEditor3::place_of_selection() const {
  if (light_) return scene()->light_places[*light_].position;
  if (corner_) return corner_;
  if (selected_.empty()) return std::nullopt;
  return scene()->polygons[selected_.front()].points.front();
}

// The selected surface that is seen at the mouse.
std::optional<std::uint32_t> SceneEditor3::selected_there(const Pointer3& pointer,
                                                          const std::optional<Face>& is_there) const {
  std::optional<Face> face = is_there;
  if (const auto first = face ? std::nullopt : pick(pointer)) face = first->face;
  const bool is_selected = face && std::ranges::binary_search(selected_, face->surface);
  return is_selected ? std::optional(face->surface) : std::nullopt;
}

// What of the selection is held at the mouse, and where.
std::optional<SceneEditor3::Grip> SceneEditor3::grip_at(const Pointer3& pointer,
                                                        const std::optional<Face>& is_there) const {
  const bool takes_corners = !pointer.is_whole && !is_of_whole_groups();
  const std::optional<Point3> corner = takes_corners ? corner_at(*scene(), selected_, pointer) : std::nullopt;
  if (corner) {
    const auto has = [&](std::uint32_t s) { return corner_at(*scene(), {s}, pointer) == corner; };
    return Grip{*corner, true, pointer.alone, *std::ranges::find_if(selected_, has)};
  }
  const std::optional<std::uint32_t> surface = selected_there(pointer, is_there);
  Pointer3 anywhere = pointer;
  anywhere.reach = HUGE_VAL;
  const std::optional<Point3> nearest = surface ? corner_at(*scene(), {*surface}, anywhere) : std::nullopt;
  return nearest ? std::optional(Grip{*nearest, false, pointer.alone, *surface}) : std::nullopt;
}

bool SceneEditor3::grab(const Pointer3& pointer, const std::optional<Face>& is_there) {
  let_go();
  grip_ = grip_at(pointer, is_there);
  if (!grip_) return false;
  refusal_.clear();
  if (pointer.is_whole) select_groups();
  corner_ = grip_->is_corner ? std::optional(grip_->anchor) : std::nullopt;
  const Pixel at = pointer.seen(place_of(grip_->anchor));
  offset_ = {at.x - pointer.at.x, at.y - pointer.at.y};
  return true;
}

void SceneEditor3::toggle_axis(int axis) {
  if (grip_) grip_->axis = grip_->axis == axis ? std::nullopt : std::optional(axis);
}

// What moves: the corner, or what is selected.
Corners3 SceneEditor3::corners_of_selection(const Scene3& scene) const {
  if (corner_) return {{*corner_}, {}};
  if (is_of_whole_groups() || (grip_ && grip_->is_alone)) return {{}, selected_};
  Corners3 corners;
  for (const std::uint32_t s : selected_)
    for (const Point3& p : corners_of(scene.polygons[s])) corners.points.push_back(p);
  return corners;
}

Scene3 SceneEditor3::moved(const Scene3& from, const Vector3& way) const {
  if (grip_ && grip_->is_corner && grip_->is_alone) return move_corner(from, grip_->surface, grip_->anchor, way);
  return move_corners(from, corners_of_selection(from), way);
}

Freedom3 SceneEditor3::freedom(const Scene3& from, const Pointer3& pointer) const {
  Freedom3 result(grip_->anchor);
  if (grip_->is_corner && grip_->is_alone) {
    const Polygon3& polygon = from.polygons[grip_->surface];
    if (corners_of(polygon).size() > 3 || from.surfaces[grip_->surface].on) result.hold(doubled_area(polygon));
  } else {
    for (const Vector3& normal : planes_to_keep(from, corners_of_selection(from))) result.hold(normal);
  }
  const std::optional<int> axis = pointer.along_axis ? axis_seen_along(place_of(grip_->anchor), pointer) : grip_->axis;
  if (axis) result.hold_on_axis(*axis);
  return result;
}

// What the drag does not snap to: all that moves.
void SceneEditor3::begin_drag() {
  history_.begin("move " + text_of_selection());
  dragged_ = history_.scene_before_drag();
  const Scene3 probe = moved(*dragged_, {1, 1, 1});
  std::vector<bool> is_moved;
  for (std::uint32_t s = 0; s < probe.polygons.size(); ++s)
    is_moved.push_back(probe.polygons[s] != dragged_->polygons[s]);
  snapper_ = std::make_unique<Snapper3>(*dragged_, std::move(is_moved));
}

void SceneEditor3::drag_grip(const Pointer3& pointer) {
  if (grip_->is_corner) corner_ = grip_->anchor;
  if (!is_dragging()) begin_drag();
  Pointer3 held = pointer;
  held.at = {pointer.at.x + offset_.x, pointer.at.y + offset_.y};
  const Freedom3 freedom = this->freedom(*dragged_, held);
  if (freedom.dimensions() == 0) {
    refusal_ = "there it cannot go: the polygons there would not be plane any more";
    return;
  }
  const Direction3 from = place_of(grip_->anchor);
  if (!is_within_reach_of_hands(from, freedom.at(held), held) || !(held.depth(freedom.at(held)) > 0)) return;
  const Point3 to = snapper_->at(held, freedom).at;
  Scene3 next = moved(*dragged_, to - grip_->anchor);
  if (!refuses(*dragged_, next)) history_.preview(std::move(next));
  if (grip_->is_corner && refusal_.empty()) corner_ = to;
}

std::string SceneEditor3::move_selection(const Vector3& way) {
  if (way.is_zero()) return "";
  const std::optional<Point3> corner = corner_;
  const std::string done = set_polygons(moved(*scene(), way), "moved", "move");
  if (corner && !done.empty()) corner_ = plus(*corner, way);
  return done;
}

std::string SceneEditor3::turn_selection(const Rational& degrees, int axis, int decimals) {
  if (selected_.empty()) return "";
  const Point3 centre = middle_of(*scene(), selected_);
  return set_polygons(rotate_surfaces(*scene(), selected_, centre, axis, degrees, decimals), "turned", "turn");
}

std::string SceneEditor3::copy_selection(const Vector3& way) {
  if (selected_.empty()) return "";
  AddedSurfaces3 added = duplicate_surfaces(*scene(), selected_, way);
  const std::string done = set_polygons(std::move(added.scene), "copied", "copy");
  if (!done.empty()) select(std::move(added.surfaces));
  return done;
}

std::string SceneEditor3::erase_selection() {
  if (selected_.empty()) return "";
  return set_polygons(erase_surfaces(*scene(), selected_), "deleted", "delete");
}

std::string SceneEditor3::reverse() {
  if (is_dragging() || selected_.empty()) return "";
  return set_polygons(reverse_surfaces(*scene(), selected_), "reversed", "reverse");
}

std::string SceneEditor3::add(AddedSurfaces3 added) {
  if (refuses(*scene(), added.scene)) return "";
  const std::string name = added.scene.groups[added.scene.surfaces[added.surfaces.front()].group].name;
  set(std::move(added.scene), "add " + name);
  select(std::move(added.surfaces));
  return "added " + name;
}

std::string SceneEditor3::add_box(const Point3& corner, const Point3& opposite, std::uint32_t material) {
  if (is_dragging()) return "";
  Point3 low = corner, high = opposite;
  for (Rational Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
    if (low.*axis > high.*axis) std::swap(low.*axis, high.*axis);
    if (low.*axis == high.*axis) {
      refusal_ = "the corners of a box differ in x, y and z";
      return "";
    }
  }
  return add(hottel::add_box(*scene(), low, high, material));
}

std::string SceneEditor3::add_rectangle(const Point3& corner, const Point3& opposite, bool looks_back,
                                        std::uint32_t material) {
  if (is_dragging()) return "";
  const std::array same{corner.x == opposite.x, corner.y == opposite.y, corner.z == opposite.z};
  if (std::ranges::count(same, true) != 1) {
    refusal_ = "opposite corners of a rectangle have one coordinate in common, x, y or z";
    return "";
  }
  return add(hottel::add_rectangle(*scene(), corner, opposite, looks_back, material));
}

}  // namespace hottel
