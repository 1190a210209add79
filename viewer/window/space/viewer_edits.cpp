// What a viewer in space does to polygons.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/space/typed_point.h"
#include "viewer/edit/typed_numbers.h"
#include "viewer/picture/palette.h"
#include "viewer/window/lights.h"
#include "viewer/window/space/light_lines.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr double kAside = 24;    // units from what is copied to its copy
constexpr double kCorner = 3.5;  // units, of a corner that can be dragged
constexpr int kNewAcross = 20;   // of the sides of what is added, across the scene
constexpr std::array kAxisNames{"x", "y", "z"};
constexpr std::array<Rational Point3::*, 3> kCoordinatesOf{&Point3::x, &Point3::y, &Point3::z};

// The axis along which a vector is longest.
std::size_t axis_across(const Vector3& normal) {
  const std::array<Rational, 3> size{abs(normal.x), abs(normal.y), abs(normal.z)};
  return static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
}

bool is_between(const Scene3& scene, const std::vector<std::uint32_t>& surfaces, const Point3& place,
                Rational Point3::*axis) {
  bool has_below = false, has_above = false;
  for (const std::uint32_t s : surfaces)
    for (const Point3& p : scene.polygons[s].points) {
      has_below = has_below || p.*axis <= place.*axis;
      has_above = has_above || p.*axis >= place.*axis;
    }
  return has_below && has_above;
}

// Whether a place lies in the box around all groups and bodies in which an edit has changed a polygon.
bool is_in_box_of_changes(const Scene3& before, const Scene3& edited, const Point3& place) {
  std::set<std::string> changed;
  const auto body_of = [&](std::uint32_t s) {
    const Group& group = edited.groups[edited.surfaces[s].group];
    return group.body.empty() ? group.name : group.body;
  };
  std::vector<std::uint32_t> surfaces;
  for (std::uint32_t s = 0; s < edited.polygons.size(); ++s)
    if (s >= before.polygons.size() || before.polygons[s] != edited.polygons[s]) changed.insert(body_of(s));
  for (std::uint32_t s = 0; s < edited.polygons.size(); ++s)
    if (changed.contains(body_of(s))) surfaces.push_back(s);
  return std::ranges::all_of(kCoordinatesOf, [&](auto axis) { return is_between(edited, surfaces, place, axis); });
}

// "z 15": an axis and degrees.
std::optional<std::pair<int, Rational>> typed_turn(const std::string& text) {
  const std::size_t at = text.find_first_not_of(' ');
  if (at == std::string::npos) return std::nullopt;
  const auto axis = std::string_view("xyz").find(text[at]);
  const auto degrees = axis == std::string_view::npos ? typed_numbers("") : typed_numbers(text.substr(at + 1));
  if (!degrees.value || degrees.value->size() != 1) return std::nullopt;
  return std::pair(static_cast<int>(axis), degrees.value->front());
}

}  // namespace

// Whether another scene has the face that this one has at an index.
bool Viewer3::knows(const Scene3& other, const Face& face) const {
  return face.surface < other.surfaces.size() && face.surface < scene()->surfaces.size() &&
         other.surfaces[face.surface].name == scene()->surfaces[face.surface].name;
}

// The face that is seen at the mouse: of the picture, where that is of the scene as it is, else what the ray meets.
std::optional<Face> Viewer3::face_at_mouse() const {
  const LiveVersion3* version = state().version.get();
  const bool is_shown = hover_ && version != nullptr && version->scene().polygons == scene()->polygons;
  if (is_shown && knows(version->scene(), hover_->face())) return hover_->face();
  const std::optional<Pick3> first = editor_.pick(pointer());
  return first ? std::optional(first->face) : std::nullopt;
}

// A click picks what lies under the mouse; with ctrl its group, with shift more than before, or less.
void Viewer3::click() {
  const std::optional<Face> face = has_mouse_ ? face_at_mouse() : std::nullopt;
  const std::vector<std::uint32_t> before = editor_.selected();
  if (!face && held_.shift) return;
  editor_.select(face ? std::vector{face->surface} : std::vector<std::uint32_t>());
  if (held_.ctrl) editor_.select_groups();
  if (held_.shift) {
    const std::vector<std::uint32_t> touched = editor_.selected();
    editor_.select(before);
    editor_.toggle(touched);
  }
  picked_ = hover_;
  ViewRequest3 request = request_;
  request.face = face && std::ranges::binary_search(editor_.selected(), face->surface) ? face : std::nullopt;
  set_request(std::move(request));
}

// No face is asked about any more.
void Viewer3::unpick() {
  picked_.reset();
  ViewRequest3 request = request_;
  request.face.reset();
  set_request(std::move(request));
}

// Picks a light, a polygon or a side of it, or a group. Throws UsageError where there is none of that name.
void Viewer3::pick(const std::string& name) {
  const auto light = std::ranges::find(scene()->lights, name, &Light::name);
  if (light != scene()->lights.end())
    return editor_.select_light(static_cast<std::uint32_t>(light - scene()->lights.begin()));
  std::vector<std::uint32_t> members;
  for (std::uint32_t s = 0; s < scene()->surfaces.size(); ++s)
    if (scene()->groups[scene()->surfaces[s].group].name == name) members.push_back(s);
  if (members.size() > 1 && !scene()->find(name)) {
    unpick();
    return editor_.select(std::move(members));
  }
  const Face face = face_of(*scene(), name);
  editor_.select({face.surface});
  pick(face);
}

void Viewer3::drag_edit() {
  editor_.drag(pointer(held_));
  message_ = editor_.refusal();
  if (const auto place = editor_.place_of_selection(); message_.empty() && place) message_ = coordinates_text_3(*place);
  scene_changed();
}

bool Viewer3::takes_key(const WindowEvent& event) {
  const auto axis = std::ranges::find(kAxisNames, event.key);
  if (drag_ != Drag::kEdit || event.held != HeldKeys() || axis == kAxisNames.end()) return false;
  editor_.toggle_axis(static_cast<int>(axis - kAxisNames.begin()));
  if (editor_.is_dragging()) drag_edit();
  return true;
}

bool Viewer3::selection_command(std::string_view name) {
  const bool is_known = name == "groups" || name == "coordinates" || name.starts_with("turn") || name == "copy" ||
                        name == "delete" || name == "reverse";
  if (!is_known) return false;
  if (editor_.is_dragging()) {
    message_ = "not while something is dragged";
  } else if (!editor_.selected_light() && editor_.selected().empty()) {
    message_ = "nothing is selected";
  } else if (name == "groups") {
    editor_.select_groups();
    message_ = fmt::format("{} polygons selected", editor_.selected().size());
  } else if (name == "coordinates") {
    ask_for_place();
  } else if (name == "copy") {
    copy_selection();
  } else if (name == "delete") {
    say(editor_.erase(), "it goes no further");
  } else if (name == "reverse") {
    say(editor_.reverse(), "a light is selected: that is for polygons");
  } else {
    turn_selection(name);
  }
  return true;
}

void Viewer3::copy_selection() {
  const Direction3 from = place_of(*editor_.place_of_selection());
  const Pointer3 hand = pointer();
  const double pixel = camera_.length_of_pixel(size_) / camera_.distance() * std::max(hand.depth(from), 0.0);
  const int decimals = decimals_at(1 / (pixel > 0 ? pixel : camera_.length_of_pixel(size_)));
  const Direction3 aside = kAside * unit_ * pixel * hand.right;
  say(editor_.duplicate(
          {rounded_decimal(aside.x, decimals), rounded_decimal(aside.y, decimals), rounded_decimal(aside.z, decimals)}),
      "it goes no further");
}

void Viewer3::turn_selection(std::string_view name) {
  if (name == "turn by") return ask_for_turn();
  const auto light = editor_.selected_light();
  const bool has_axis = !light || scene()->lights[*light].type != LightType::kPoint;
  const Rational degrees = name == "turn" ? 15 : name == "turn back" ? -15 : 90;
  // The vertical of polygons is the axis to which `up` of the camera is nearest, that of lights z.
  const std::size_t vertical = axis_across(home_.up);
  const std::array up{home_.up.x, home_.up.y, home_.up.z};
  const bool is_down = !light && up[vertical] < 0;
  say(editor_.rotate(is_down ? Rational(-degrees) : degrees, static_cast<int>(vertical),
                     decimals_at(1 / camera_.length_of_pixel(size_)) + 2),
      !has_axis ? "a point light has no axis to turn" : "it turns about the vertical, and that is its axis");
}

void Viewer3::ask_for_turn() {
  if (editor_.selected_light()) {
    message_ = "a light is selected: that is for polygons";
    return;
  }
  prompt_ = Prompt{.question = "turns about x, y or z by degrees",
                   .text = "z 15",
                   .answer = [this](const std::string& text) -> std::string {
                     const auto turn = typed_turn(text);
                     if (!turn) return "an axis and degrees, as z 15";
                     const int decimals = decimals_at(1 / camera_.length_of_pixel(size_)) + 2;
                     message_ = editor_.rotate(turn->second, turn->first, decimals);
                     scene_changed();
                     return editor_.refusal();
                   },
                   .is_selected = true};
}

// A coordinate that is typed as it was shown stays, with all the digits that it has.
void Viewer3::ask_for_place() {
  const Point3 from = *editor_.place_of_selection();
  const std::string shown = coordinates_text_3(from);
  prompt_ = Prompt{.question = "goes to", .text = shown, .answer = [this, from, shown](const std::string& text) {
                     Typed<Point3> typed = typed_point_3(text);
                     if (!typed.value) return typed.problem;
                     const Point3 rounded = *typed_point_3(shown).value;
                     for (const auto axis : kCoordinatesOf)
                       if ((*typed.value).*axis == rounded.*axis) (*typed.value).*axis = from.*axis;
                     message_ = editor_.move_to(*typed.value);
                     scene_changed();
                     return editor_.refusal();
                   }};
}

bool Viewer3::add_command(std::string_view name) {
  if (name != "box" && name != "rectangle") return false;
  if (editor_.is_dragging())
    message_ = "not while something is dragged";
  else if (scene()->materials.empty())
    message_ = "there is no material to make it of";
  else
    ask_for_corners(name == "box");
  return true;
}

// The material under the mouse, else the first one that does not shine.
std::uint32_t Viewer3::material_of_new() const {
  if (hover_ && hover_->element().material) return *hover_->element().material;
  const auto dark = std::ranges::find_if(scene()->materials, [](const Material& m) { return m.emission.is_zero(); });
  return dark == scene()->materials.end() ? 0 : static_cast<std::uint32_t>(dark - scene()->materials.begin());
}

// Asks for two opposite corners: on the surface under the mouse, a twentieth of the scene to each side of that.
void Viewer3::ask_for_corners(bool is_box) {
  const Pointer3 hand = pointer();
  const std::optional<Pick3> picked = has_mouse_ ? editor_.pick(hand) : std::nullopt;
  const Direction3 at = picked ? place_of(picked->place) : hand.eye + camera_.distance() * hand.forward;
  const int decimals = decimals_at(1 / hand.length_of_pixel(at));
  const Rational half = std::max(rounded_decimal(camera_.size() / kNewAcross, decimals), decimal_step(decimals));
  const std::size_t across = picked ? axis_across(doubled_area(scene()->polygons[picked->face.surface])) : 2;
  const std::array<double, 3> place{at.x, at.y, at.z}, eye{hand.eye.x, hand.eye.y, hand.eye.z};
  const bool looks_back = eye[across] < place[across];
  Point3 low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational middle = rounded_decimal(place[k], decimals);
    low.*kCoordinatesOf[k] = middle - half;
    high.*kCoordinatesOf[k] = middle + half;
  }
  const auto axis = kCoordinatesOf[across];
  const bool is_on_axis = picked && rounded_decimal(picked->place.*axis, decimals + 3) == picked->place.*axis;
  low.*axis = high.*axis = is_on_axis ? picked->place.*axis : rounded_decimal(place[across], decimals);
  if (is_box) (looks_back ? low : high).*axis += (looks_back ? -2 : 2) * half;
  prompt_ = Prompt{.question = (is_box ? "a box of '" : "a rectangle of '") +
                               scene()->materials[material_of_new()].name + "' between two corners",
                   .text = coordinates_text_3(low) + "; " + coordinates_text_3(high),
                   .answer = [this, is_box, looks_back, material = material_of_new()](const std::string& text) {
                     return add_between(is_box, looks_back, material, text);
                   }};
}

// Adds what is typed; returns why it cannot be.
std::string Viewer3::add_between(bool is_box, bool looks_back, std::uint32_t material, const std::string& text) {
  const Typed<std::vector<Rational>> typed = typed_numbers(text);
  if (!typed.value) return typed.problem;
  const std::vector<Rational>& n = *typed.value;
  if (n.size() != 6) return "two corners have six coordinates; there are " + std::to_string(n.size());
  if (material >= scene()->materials.size()) return "the material is not there any more";
  const Point3 from{n[0], n[1], n[2]}, to{n[3], n[4], n[5]};
  message_ = is_box ? editor_.add_box(from, to, material) : editor_.add_rectangle(from, to, looks_back, material);
  if (!message_.empty()) unpick();
  scene_changed();
  return message_.empty() ? editor_.refusal() : "";
}

// The face that is picked keeps its name.
void Viewer3::keep_picked(const Scene3& before) {
  if (!request_.face || request_.face->surface >= before.surfaces.size()) return;
  const std::string& name = before.surfaces[request_.face->surface].name;
  if (request_.face->surface < scene()->surfaces.size() && scene()->surfaces[request_.face->surface].name == name)
    return;
  ViewRequest3 request = request_;
  const std::optional<std::uint32_t> now = scene()->find(name);
  request.face = now ? std::optional(Face{*now, request_.face->is_back}) : std::nullopt;
  if (!now) picked_.reset();
  set_request(std::move(request));
}

// Why an edited scene may not be so: the eye would be in a solid.
std::string Viewer3::why_not_stand(const Scene3& edited) const {
  const Point3 eye = camera_.camera(size_).eye;
  if (!is_in_box_of_changes(*scene(), edited, eye)) return "";
  try {
    const Solids3 solids(edited);
    const auto mesh = solids.around(eye);
    return mesh ? "the eye would be in the solid " + quoted_name(solids.meshes()[*mesh].name) : "";
  } catch (const InputError&) {
    return "";  // what cannot be a solid is told where the light is
  }
}

// The borders of what is selected, whatever hides them, and corners to be dragged.
void Viewer3::draw_selection(PictureCanvas& canvas) const {
  const auto draw_loop = [&](const std::vector<Point3>& points) {
    for (std::size_t k = 0; k < points.size(); ++k)
      if (const auto line = camera_.line(place_of(points[k]), place_of(points[(k + 1) % points.size()]), size_))
        canvas.stroke(Mark::kTarget, within_canvas(line->first), within_canvas(line->second), palette::kTarget,
                      2.5 * unit_);
  };
  for (const std::uint32_t s : editor_.selected())
    for (const auto& loop : loops_of(scene()->polygons[s])) draw_loop(loop);
  const auto draw_corner = [&](const Point3& corner, double size) {
    if (const auto at = camera_.at(place_of(corner), size_))
      canvas.disc(Mark::kTarget, within_canvas(*at), size * kCorner * unit_, palette::kTarget);
  };
  if (editor_.selected().size() == 1)
    for (const Point3& p : corners_of(scene()->polygons[editor_.selected().front()])) draw_corner(p, 1);
  if (editor_.selected_corner()) draw_corner(*editor_.selected_corner(), 1.7);
}

}  // namespace hottel
