// The events of a viewer.
#include <utility>

#include "geometry/scene_names.h"
#include "viewer/edit/decimals.h"
#include "viewer/window/lights.h"
#include "viewer/window/plane/viewer.h"

namespace hottel {

Pointer2 Viewer2::pointer(const HeldKeys& held) const {
  return {.place = place(),
          .reach = kReach * unit_ / camera_.pixels_per_length(),
          .arm = kLightArm * unit_ / camera_.pixels_per_length(),
          .decimals = decimals_at(camera_.pixels_per_length()),
          .adds = held.shift,
          .alone = held.alt,
          .is_whole = held.ctrl};
}

// Finds what lies under the mouse, in the scene as it is now.
void Viewer2::touch() {
  const Pointer2 mouse = pointer();
  hover_light_ = has_mouse_ && !tool_ ? pick_light(*shown_scene(), mouse.place, mouse.reach, mouse.arm) : std::nullopt;
  hover_ = has_mouse_ && !hover_light_ ? editor_.pick(pointer()) : Pick2();
}

// The place of the mouse as a short decimal, finer than a pixel.
Point2 Viewer2::exact_mouse() const {
  const int decimals = decimals_at(camera_.pixels_per_length()) + 1;
  const Place2 at = place();
  return {rounded_decimal(at[0], decimals), rounded_decimal(at[1], decimals)};
}

void Viewer2::follow_mouse() {
  touch();
  request_changed();
}

// About what is under the mouse, which stays there.
void Viewer2::zoom(double times) {
  camera_.zoom(mouse_, size_, times);
  is_fitted_ = false;
  views_.set_tone(tone_, texture_pixels());
  needs_base_ = true;
  if (drag_ == Drag::kNone) touch();
  request_changed();
}

// The whole scene stays in sight, unless the view was moved by hand.
void Viewer2::size_changed() {
  if (is_fitted_) fit();
}

void Viewer2::press(const WindowEvent& event) {
  if (prompt_ || drag_ != Drag::kNone) return;
  pressed_ = mouse_;
  button_ = event.button;
  held_ = event.held;
  if (!tool_) message_.clear();
  has_moved_ = false;
  if (event.button != MouseButton::kLeft) {
    drag_ = Drag::kPan;
    return;
  }
  if (tool_) return add_tool_point();
  if (request_.mode == ViewMode2::kErrors && is_on_bar()) {
    drag_ = Drag::kBar;
    return;
  }
  if (time_ && hover_light_) stop();
  drag_ = editor_.press(pointer(event.held)) ? Drag::kEdit : event.held.shift ? Drag::kRectangle : Drag::kPan;
}

void Viewer2::move(const Pixel& before) {
  has_moved_ = has_moved_ || !is_still();
  switch (drag_) {
    case Drag::kNone:
      touch();
      break;
    case Drag::kEdit:
      if (has_moved_ && !held_.shift) {
        editor_.drag(pointer(held_));
        scene_changed();
      }
      break;
    case Drag::kPan:
      camera_.pan(mouse_.x - before.x, mouse_.y - before.y);
      is_fitted_ = false;
      needs_base_ = true;
      break;
    case Drag::kBar:
      split_ = mouse_.x / size_.width;
      needs_base_ = true;
      break;
    case Drag::kRectangle:
      break;
  }
  request_changed();
}

void Viewer2::release(const WindowEvent& event) {
  if (event.button != button_) return;
  const Drag ended = std::exchange(drag_, Drag::kNone);
  if (ended == Drag::kEdit) {
    if (editor_.is_dragging()) {
      editor_.release();
      shown_version_ = 0;  // the same scene, at rest now
      scene_changed();
    } else {
      editor_.release();
      if (event.button == MouseButton::kLeft) click();
    }
  }
  if (ended == Drag::kRectangle) editor_.select_in(camera_.place_of(pressed_, size_), place(), held_.ctrl);
  if (ended == Drag::kPan && !has_moved_ && event.button == MouseButton::kLeft && !held_.shift) editor_.select_none();
  follow_mouse();
}

// The face that is meant by pointing at an edge: its front where the back is black and exchanges nothing.
Face Viewer2::asked_face(const Pick2& pick) const {
  const bool has_back = pick.face.is_back && editor_.scene()->surfaces[pick.face.surface].back;
  return {pick.face.surface, has_back};
}

std::string Viewer2::asked_name(const Pick2& pick) const { return face_name(*editor_.scene(), asked_face(pick)); }

// A click on an edge picks its face if the view mode is about faces.
void Viewer2::click() {
  if (editor_.selected_light()) return;
  const Pick2 found = editor_.pick(pointer());
  if (!found.surface) return;
  const std::string face = asked_name(found);
  if (request_.mode == ViewMode2::kFactors ||
      (request_.mode == ViewMode2::kPair && (!request_.face || request_.other))) {
    request_.face = face;
    request_.other.reset();
  } else if (request_.mode == ViewMode2::kPair) {
    request_.other = face;
  }
  needs_base_ = true;
}

}  // namespace hottel
