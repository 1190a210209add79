// The events of a viewer in space.
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "viewer/window/lights.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr double kDegreesAcross = 180;  // of a drag over the height of the window

Direction3 in_doubles(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }
Direction3 in_doubles(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }

// Counts, even or odd, how often a ray in the plane of a loop crosses it: seen along the longest axis of the normal.
bool crosses_oddly(const std::vector<Point3>& loop, const Direction3& normal, const Direction3& place) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const auto flat = [&](const Direction3& p) {
    return z >= x && z >= y ? std::array{p.x, p.y} : y >= x ? std::array{p.z, p.x} : std::array{p.y, p.z};
  };
  const std::array<double, 2> at = flat(place);
  bool is_odd = false;
  std::array<double, 2> before = flat(in_doubles(loop.back()));
  for (const Point3& corner : loop) {
    const std::array<double, 2> now = flat(in_doubles(corner));
    if ((before[1] > at[1]) != (now[1] > at[1])) {
      const double share = (at[1] - before[1]) / (now[1] - before[1]);
      if (at[0] < std::lerp(before[0], now[0], share)) is_odd = !is_odd;
    }
    before = now;
  }
  return is_odd;
}

bool holds(const Polygon3& polygon, const Direction3& normal, const Direction3& place) {
  bool is_in = crosses_oddly(polygon.points, normal, place);
  for (const auto& hole : polygon.holes) is_in = is_in != crosses_oddly(hole, normal, place);
  return is_in;
}

// Returns where the first polygon of a scene is met on a way from the eye, whichever of its sides; nothing where none
// is. In doubles, for a hand: what all but touches may be taken for what it touches. COST: linear in the corners.
std::optional<Direction3> first_place_on_way_3(const Scene3& scene, const Direction3& eye, const Direction3& way) {
  std::optional<Direction3> first;
  double nearest = HUGE_VAL;
  for (const Polygon3& polygon : scene.polygons) {
    const Direction3 normal = in_doubles(doubled_area(polygon));
    const double along = dot(normal, in_doubles(polygon.points[0]) - eye) / dot(normal, way);
    if (!(along > 0 && along < nearest)) continue;
    const Direction3 place = eye + along * way;
    if (!holds(polygon, normal, place)) continue;
    nearest = along;
    first = place;
  }
  return first;
}

}  // namespace

// Finds what lies under the mouse.
void Viewer3::touch() {
  hover_light_ = has_mouse_ ? pick_light(*shown_, pointer()) : std::nullopt;
  const SeenPicture3::Part* part = has_mouse_ && !hover_light_ ? part_at(mouse_) : nullptr;
  hover_.reset();
  if (part != nullptr && part->element) hover_ = LiveElement3{seen()->model, *part->element};
}

// Held: shift keeps what is dragged on an axis, ctrl aims a light at what lies under the mouse.
Pointer3 Viewer3::pointer(const HeldKeys& held) const {
  Pointer3 result = camera_.pointer(mouse_, size_);
  result.reach = kReach * unit_;
  result.arm = kLightArm * unit_;
  result.along_axis = held.shift;
  result.alone = held.alt;
  result.is_whole = held.ctrl;
  if (held.ctrl) result.aim = surface_at(mouse_);
  return result;
}

// The place of a surface with light that is seen there.
std::optional<Direction3> Viewer3::surface_at(const Pixel& place) const {
  const SeenPicture3::Part* part = part_at(place);
  if (part == nullptr || !part->element) return std::nullopt;
  const LiveModel3& model = *seen()->model;
  const Polygon3& polygon = model.prepared.scene.polygons[model.table().elements()[*part->element].surface];
  const Vector3 area = doubled_area(polygon);
  const Direction3 normal = unit({to_double(area.x), to_double(area.y), to_double(area.z)});
  const Pointer3 from = camera_.pointer(place, size_);
  const Direction3 ray = from.way_to(from.at);
  const double along = dot(normal, place_of(polygon.points[0]) - from.eye) / dot(normal, ray);
  return std::isfinite(along) ? std::optional(from.eye + along * ray) : std::nullopt;
}

Direction3 Viewer3::pointed_place(const Pixel& place) const {
  const Pointer3 from = camera_.pointer(place, size_);
  const Direction3 way = from.way_to(from.at);
  if (const std::optional<Direction3> surface = surface_at(place)) return *surface;
  if (const std::optional<Direction3> first = first_place_on_way_3(*shown_, from.eye, way)) return *first;
  return from.eye + (camera_.distance() / dot(way, from.forward)) * way;
}

// Goes nearer to what is under the mouse, which stays there.
void Viewer3::zoom(double times) {
  EyeCamera3 camera = camera_;
  camera.zoom_to(pointed_place(mouse_), times);
  see(camera);
}

void Viewer3::press(const WindowEvent& event) {
  if (prompt_ || drag_ != Drag::kNone) return;
  pressed_ = mouse_;
  button_ = event.button;
  held_ = event.held;
  has_moved_ = false;
  message_.clear();
  drag_ = drag_of(event);
  if (drag_ == Drag::kPan) grabbed_ = pointed_place(pressed_);
}

// What the mouse does from there on.
Viewer3::Drag Viewer3::drag_of(const WindowEvent& press) {
  if (press.button != MouseButton::kLeft) return Drag::kPan;
  if (!press.held.shift && is_split() && is_on_bar()) return Drag::kBar;
  if (time_ && pick_light(*shown_, pointer())) stop();
  if (editor_.press(pointer(press.held))) return Drag::kLight;
  if (!time_ && editor_.grab(pointer(press.held), face_at_mouse())) return Drag::kEdit;
  if (press.held.shift) return Drag::kPan;
  return press.held.ctrl ? Drag::kTurn : Drag::kOrbit;
}

void Viewer3::move(const Pixel& before) {
  if (drag_ == Drag::kNone) return touch();
  if (!has_moved_ && is_still()) return;
  // What lies under the mouse goes with it from where it was pressed.
  const Pixel from = std::exchange(has_moved_, true) ? before : pressed_;
  const double right = mouse_.x - from.x, down = mouse_.y - from.y;
  if (drag_ == Drag::kBar) {
    split_ = mouse_.x / size_.width;
    needs_base_ = true;
  } else if (drag_ == Drag::kLight) {
    editor_.drag(pointer(held_));
    message_ = editor_.refusal();
    scene_changed();
  } else if (drag_ == Drag::kEdit) {
    drag_edit();
  } else {
    move_eye(right, down);
  }
}

void Viewer3::move_eye(double right, double down) {
  EyeCamera3 camera = camera_;
  const double degrees = kDegreesAcross / size_.height;
  if (drag_ == Drag::kOrbit) {
    camera.orbit(-right * degrees, down * degrees);
  } else if (drag_ == Drag::kTurn) {
    camera.turn(-right * degrees / 2, down * degrees / 2);
  } else {
    // What was grabbed comes back under the mouse, wherever the eye has gone.
    const std::optional<Pixel> now = camera_.at(grabbed_, size_);
    if (!now) return;
    const double length = camera_.length_of_pixel_at(grabbed_, size_);
    camera.pan((now->x - mouse_.x) * length, (mouse_.y - now->y) * length);
  }
  see(camera);
}

void Viewer3::release(const WindowEvent& event) {
  if (drag_ == Drag::kNone || event.button != button_) return;
  const bool was_edited = editor_.is_dragging();
  const Drag ended = std::exchange(drag_, Drag::kNone);
  if (ended == Drag::kLight || ended == Drag::kEdit) {
    editor_.release();
    scene_changed();
    if (ended == Drag::kEdit && was_edited) tell();  // the same scene, at rest now
  }
  touch();
  const bool holds_corner = ended == Drag::kEdit && editor_.selected_corner();
  if (has_moved_ || ended == Drag::kBar || ended == Drag::kLight || holds_corner) return;
  if (event.button == MouseButton::kLeft) click();
}

// Picks a polygon by its first element, as it is numbered, that there is something of.
void Viewer3::pick(const Face& face) {
  ViewRequest3 request = request_;
  request.face = face;
  picked_.reset();
  if (state().version) {
    const auto& model = state().version->shared_model();
    for (LiveElement3 e{model}; e.number < model->table().count() && !picked_; ++e.number)
      if (model->table().has_row(e.number) && e.face() == face) picked_ = e;
  }
  set_request(std::move(request));
}

}  // namespace hottel
