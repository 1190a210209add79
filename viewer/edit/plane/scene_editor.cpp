#include "viewer/edit/plane/scene_editor.h"

#include <algorithm>

#include "geometry/plane/scene/bounding_box.h"
#include "geometry/scene_names.h"
#include "viewer/edit/light_list.h"

namespace hottel {
namespace {

bool is_before(const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

std::string counted(std::size_t n) { return n == 1 ? "an edge" : std::to_string(n) + " edges"; }

}  // namespace

SceneEditor2::SceneEditor2(Scene2 scene) : history_(std::move(scene)) { changed(); }

void SceneEditor2::replace(Scene2 scene) {
  held_.reset();
  held_light_.reset();
  history_ = EditHistory<Scene2>(std::move(scene));
  select_none();
  changed();
}

void SceneEditor2::changed() {
  ++version_;
  if (picked_ == scene()) return;
  picked_ = scene();
  picker_ = std::make_unique<ScenePick2>(*picked_);
}

// What is held is of the scene before.
void SceneEditor2::set(Scene2 next, const std::string& what) {
  held_.reset();
  held_light_.reset();
  const std::shared_ptr<const Scene2> before = scene();
  history_.set(std::move(next), what);
  set_selected_names(*before, selected_);
  changed();
}

// Selects what is called as it was in another scene.
void SceneEditor2::set_selected_names(const Scene2& before, const Selection& surfaces) {
  selected_ = selection_called_as(before, surfaces, *scene());
  light_ = light_called_as(before, light_, *scene());
}

Pick2 SceneEditor2::pick(const Pointer2& pointer) const { return picker_->at(pointer.place, pointer.reach); }

Snap2 SceneEditor2::snap(const Pointer2& pointer) const {
  return snapped(*scene(), pointer.place, {.decimals = pointer.decimals, .reach = pointer.reach});
}

void SceneEditor2::select(Selection surfaces) {
  selected_ = selection_of(std::move(surfaces));
  vertex_.reset();
  light_.reset();
}

void SceneEditor2::select_all() {
  std::vector<std::uint32_t> all(scene()->surfaces.size());
  for (std::uint32_t s = 0; s < all.size(); ++s) all[s] = s;
  select(std::move(all));
}

void SceneEditor2::select_none() { select({}); }

void SceneEditor2::select_groups() { select(whole_groups(*scene(), selected_)); }

void SceneEditor2::select_in(const Place2& corner, const Place2& opposite, bool adds) {
  Selection inside = picker_->in_rectangle(corner, opposite);
  if (adds) inside.insert(inside.end(), selected_.begin(), selected_.end());
  select(std::move(inside));
}

bool SceneEditor2::press(const Pointer2& pointer) {
  held_.reset();
  held_light_ = pick_light(pointer);
  if (held_light_) {
    hold_light(pointer);
    return true;
  }
  const Pick2 found = pick(pointer);
  if (!found.surface) return false;
  if (pointer.adds) {
    const Selection touched{*found.surface};
    select(toggled(selected_, *found.surface, pointer.is_whole ? whole_groups(*scene(), touched) : touched));
    return true;
  }
  const bool is_selected = std::ranges::binary_search(selected_, *found.surface);
  const bool is_vertex = found.vertex && !pointer.is_whole && !(is_selected && is_of_whole_groups());
  if (!is_selected || pointer.is_whole || is_vertex) {
    select({*found.surface});
    if (pointer.is_whole) select_groups();
  }
  const std::uint32_t surface = is_vertex ? surface_at(*found.vertex, *found.surface) : *found.surface;
  const Edge2 edge = scene()->edges[surface];
  Held held{.surface = surface, .is_last = found.is_last, .is_vertex = is_vertex, .anchor = {}};
  held.anchor = is_vertex ? *found.vertex : found.is_last ? edge.to : edge.from;
  held.is_last = is_vertex && edge.from != edge.to ? held.anchor == edge.to : found.is_last;
  held.moves_alone = pointer.alone || (!is_vertex && is_of_whole_groups());
  const Place2 anchor = to_doubles(held.anchor);
  held.offset = {anchor[0] - pointer.place[0], anchor[1] - pointer.place[1]};
  if (is_vertex) {
    select_none();
    vertex_ = held.anchor;
  }
  held_ = held;
  return true;
}

// A surface with an end at a vertex: this one where it has, else the first.
std::uint32_t SceneEditor2::surface_at(const Point2& vertex, std::uint32_t surface) const {
  const auto ends_there = [&](const Edge2& edge) { return edge.from == vertex || edge.to == vertex; };
  const std::vector<Edge2>& edges = scene()->edges;
  if (ends_there(edges[surface])) return surface;
  return static_cast<std::uint32_t>(std::ranges::find_if(edges, ends_there) - edges.begin());
}

// Each once, in the order of is_before.
std::vector<Point2> SceneEditor2::ends_of_selection(const Scene2& from) const {
  std::vector<Point2> ends;
  for (const std::uint32_t s : selected_) {
    ends.push_back(from.edges[s].from);
    ends.push_back(from.edges[s].to);
  }
  std::sort(ends.begin(), ends.end(), is_before);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

std::vector<PointMove2> SceneEditor2::moves_of_selection(const Scene2& from, const Rational& dx,
                                                         const Rational& dy) const {
  std::vector<PointMove2> moves;
  for (const Point2& end : ends_of_selection(from)) moves.push_back({end, {end.x + dx, end.y + dy}});
  return moves;
}

// The surfaces that a drag moves, and that it does not snap to.
std::vector<std::uint32_t> SceneEditor2::surfaces_that_move(const Scene2& from, const Held& held) const {
  if (held.moves_alone) return held.is_vertex ? std::vector<std::uint32_t>{held.surface} : selected_;
  const std::vector<Point2> ends = held.is_vertex ? std::vector<Point2>{held.anchor} : ends_of_selection(from);
  const auto is_moved = [&](const Point2& p) { return std::binary_search(ends.begin(), ends.end(), p, is_before); };
  std::vector<std::uint32_t> surfaces;
  for (std::uint32_t s = 0; s < from.edges.size(); ++s)
    if (is_moved(from.edges[s].from) || is_moved(from.edges[s].to)) surfaces.push_back(s);
  return surfaces;
}

Scene2 SceneEditor2::moved(const Scene2& from, const Held& held, const Point2& to) const {
  const Rational dx = to.x - held.anchor.x, dy = to.y - held.anchor.y;
  if (held.is_vertex)
    return held.moves_alone ? move_end(from, held.surface, held.is_last, to)
                            : move_points(from, std::vector<PointMove2>{{held.anchor, to}});
  return held.moves_alone ? move_surfaces(from, selected_, dx, dy)
                          : move_points(from, moves_of_selection(from, dx, dy));
}

void SceneEditor2::drag(const Pointer2& pointer) {
  if (held_light_) return drag_light(pointer);
  if (!held_) return;
  if (!is_dragging()) {
    history_.begin(held_->is_vertex ? "move a vertex" : "move " + counted(selected_.size()));
    snapper_ = std::make_unique<Snapper2>(*history_.scene_before_drag());
    selected_before_ = selected_;
    moving_ = surfaces_that_move(*history_.scene_before_drag(), *held_);
  }
  const Scene2& before = *history_.scene_before_drag();
  const Place2 place{pointer.place[0] + held_->offset[0], pointer.place[1] + held_->offset[1]};
  const Snap2 target = snapper_->at(place, {.decimals = pointer.decimals, .reach = pointer.reach, .moved = moving_});
  selected_ = selected_before_;
  history_.preview(moved(before, *held_, target.at));
  set_selected_names(before, selected_before_);
  if (held_->is_vertex) vertex_ = target.at;
  changed();
}

void SceneEditor2::release() {
  if (is_dragging()) {
    const Scene2& before = *history_.scene_before_drag();
    if (scene()->edges == before.edges && scene()->lights == before.lights &&
        scene()->light_places == before.light_places)
      return cancel();
    history_.commit();
  }
  held_.reset();
  held_light_.reset();
}

void SceneEditor2::cancel() {
  if (is_dragging()) {
    history_.cancel();
    selected_ = selected_before_;
    if (held_ && held_->is_vertex) vertex_ = held_->anchor;
    changed();
  }
  held_.reset();
  held_light_.reset();
}

// To the scene before the last step, or to the one after it.
std::string SceneEditor2::go(bool is_back) {
  const std::shared_ptr<const Scene2> before = scene();
  const std::string what = is_back ? history_.what_undo() : history_.what_redo();
  if (!(is_back ? history_.undo() : history_.redo())) return "";
  held_.reset();
  held_light_.reset();
  set_selected_names(*before, selected_);
  vertex_.reset();
  changed();
  return (is_back ? "undone: " : "done again: ") + what;
}

std::string SceneEditor2::undo() {
  if (!is_dragging()) return go(true);
  cancel();
  return "drag dropped";
}

std::string SceneEditor2::redo() { return go(false); }

std::string SceneEditor2::move_by(const Rational& dx, const Rational& dy) {
  if (is_dragging() || (dx == 0 && dy == 0)) return "";
  if (light_) return set_light(move_light(*scene(), *light_, dx, dy), "moved", "move", *light_);
  if (vertex_) {
    const Point2 to{vertex_->x + dx, vertex_->y + dy};
    set(move_points(*scene(), std::vector<PointMove2>{{*vertex_, to}}), "move a vertex");
    vertex_ = to;
    return "moved a vertex";
  }
  if (selected_.empty()) return "";
  set(is_of_whole_groups() ? move_surfaces(*scene(), selected_, dx, dy)
                           : move_points(*scene(), moves_of_selection(*scene(), dx, dy)),
      "move " + counted(selected_.size()));
  return "moved " + counted(selected_.size());
}

std::string SceneEditor2::move_to(const Point2& place) {
  if (!light_ && !vertex_ && selected_.empty()) return "";
  const Point2 from = light_    ? scene()->light_places[*light_].position
                      : vertex_ ? *vertex_
                                : scene()->edges[selected_.front()].from;
  return move_by(place.x - from.x, place.y - from.y);
}

std::string SceneEditor2::rotate(const Rational& degrees, int decimals) {
  if (light_ && !is_dragging()) return set_light(turn_light(*scene(), *light_, degrees), "turned", "turn", *light_);
  if (is_dragging() || selected_.empty()) return "";
  Box2 box = Box2::of(scene()->edges[selected_.front()].from);
  for (const std::uint32_t s : selected_) {
    box.include(scene()->edges[s].from);
    box.include(scene()->edges[s].to);
  }
  const Point2 centre{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2};
  set(rotate_surfaces(*scene(), selected_, centre, degrees, decimals), "turn " + counted(selected_.size()));
  return "turned " + counted(selected_.size());
}

std::string SceneEditor2::duplicate(const Rational& dx, const Rational& dy) {
  if (light_ && !is_dragging())
    return set_light(duplicate_light(*scene(), *light_, dx, dy), "copied", "copy",
                     static_cast<std::uint32_t>(scene()->lights.size()));
  if (is_dragging() || selected_.empty()) return "";
  AddedSurfaces2 added = duplicate_surfaces(*scene(), selected_, dx, dy);
  set(std::move(added.scene), "copy " + counted(selected_.size()));
  select(std::move(added.surfaces));
  return "copied " + counted(selected_.size());
}

std::string SceneEditor2::erase() {
  if (light_ && !is_dragging()) {
    const std::string name = scene()->lights[*light_].name;
    set(erase_light(*scene(), *light_), "delete " + name);
    return "deleted " + name;
  }
  if (is_dragging() || selected_.empty()) return "";
  const std::size_t count = selected_.size();
  set(erase_surfaces(*scene(), selected_), "delete " + counted(count));
  select_none();
  return "deleted " + counted(count);
}

std::string SceneEditor2::reverse() {
  if (is_dragging() || selected_.empty()) return "";
  set(reverse_surfaces(*scene(), selected_), "reverse " + counted(selected_.size()));
  return "reversed " + counted(selected_.size());
}

std::string SceneEditor2::add_line(const std::vector<Point2>& points, bool closed, std::uint32_t material) {
  if (is_dragging() || points.size() < 2) return "";
  AddedSurfaces2 added = points.size() == 2 && !closed ? hottel::add_edge(*scene(), {points[0], points[1]}, material)
                                                       : hottel::add_polyline(*scene(), points, closed, material);
  set(std::move(added.scene), "add " + counted(added.surfaces.size()));
  select(std::move(added.surfaces));
  return "added " + scene()->groups[scene()->surfaces[selected_.front()].group].name;
}

std::string SceneEditor2::add_lamp(const Point2& centre, const Rational& half_size) {
  if (is_dragging()) return "";
  AddedSurfaces2 added = hottel::add_lamp(*scene(), centre, half_size);
  set(std::move(added.scene), "add a lamp");
  select(std::move(added.surfaces));
  return "added " + scene()->groups[scene()->surfaces[selected_.front()].group].name;
}

std::string SceneEditor2::change_material(const Face& face, bool copies_first,
                                          const std::function<void(Material&)>& change) {
  if (is_dragging()) return "";
  std::optional<std::uint32_t> material = material_of(*scene(), face);
  if (!material) return "";
  Scene2 next = *scene();
  if (copies_first) {
    AddedMaterial2 copy = *copy_material(next, face);
    next = std::move(copy.scene);
    material = copy.material;
  }
  Material values = next.materials[*material];
  change(values);
  if (!copies_first && values == next.materials[*material]) return "";
  set(set_material(next, *material, values), "change " + values.name);
  return values.name;
}

}  // namespace hottel
