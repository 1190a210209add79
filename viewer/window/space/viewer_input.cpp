// The events of a viewer in space.
#include <cmath>
#include <utility>

#include "viewer/window/lights.h"
#include "viewer/window/space/pointed_place.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr double kDegreesAcross = 180;  // of a drag over the height of the window

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
