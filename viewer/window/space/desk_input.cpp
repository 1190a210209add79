// The events of a desk in space.
#include <cmath>
#include <utility>

#include "viewer/window/space/commands.h"
#include "viewer/window/space/desk.h"

namespace hottel {
namespace {

constexpr double kReach = 9;            // units that count as touching
constexpr double kStill = 3;            // units that a click may wander
constexpr double kPerNotch = 1.2;       // of the wheel
constexpr double kDegreesAcross = 180;  // of a drag over the height of the window

double distance(const Pixel& a, const Pixel& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

// Finds what lies under the mouse.
void Desk3::touch() {
  const SeenPicture3::Part* part = has_mouse_ && seen() ? seen()->at(mouse_) : nullptr;
  hover_ = part != nullptr ? part->element : std::nullopt;
}

bool Desk3::is_on_bar() const { return is_split() && std::abs(mouse_.x - split_ * size_.width) < kReach * unit_; }

void Desk3::handle(const WindowEvent& event) {
  using Kind = WindowEvent::Kind;
  needs_frame_ = needs_frame_ || event.kind != Kind::kWake;
  const bool is_at_a_place = event.kind == Kind::kMove || event.kind == Kind::kPress || event.kind == Kind::kRelease ||
                             event.kind == Kind::kWheel;
  const Pixel before = mouse_;
  if (is_at_a_place) {
    mouse_ = {event.x, event.y};
    has_mouse_ = true;
  }
  switch (event.kind) {
    case Kind::kQuit:
      return quit();
    case Kind::kResize:
      size_ = window_.size();
      needs_base_ = true;
      return;
    case Kind::kMove:
      return move(before);
    case Kind::kLeave:
      has_mouse_ = false;
      return touch();
    case Kind::kPress:
      return press(event);
    case Kind::kRelease:
      return release(event);
    case Kind::kWheel: {
      EyeCamera3 camera = camera_;
      camera.zoom(std::pow(kPerNotch, event.wheel));
      return see(camera);
    }
    case Kind::kKey:
      if (prompt_) {
        drops_text_ = false;
        return answer_prompt(prompt_, event);
      }
      if (const auto name = command_of_key(key_text(event), commands_3()); !name.empty()) command(name);
      drops_text_ = prompt_ && event.key.size() == 1 && !event.held.ctrl && !event.held.alt;
      return;
    case Kind::kText:
      if (!std::exchange(drops_text_, false) && prompt_ && prompt_->keys.empty()) prompt_->text += event.text;
      return;
    case Kind::kFocus:
      until_watch_ = 0;
      return;
    case Kind::kWake:
      return;
  }
}

void Desk3::press(const WindowEvent& event) {
  if (prompt_ || drag_ != Drag::kNone) return;
  pressed_ = mouse_;
  button_ = event.button;
  has_moved_ = false;
  message_.clear();
  if (event.button != MouseButton::kLeft || event.held.shift)
    drag_ = Drag::kPan;
  else if (is_on_bar())
    drag_ = Drag::kBar;
  else
    drag_ = event.held.ctrl ? Drag::kTurn : Drag::kOrbit;
}

void Desk3::move(const Pixel& before) {
  if (drag_ == Drag::kNone) return touch();
  if (!has_moved_ && distance(mouse_, pressed_) <= kStill * unit_) return;
  // What lies under the mouse goes with it from where it was pressed.
  const Pixel from = std::exchange(has_moved_, true) ? before : pressed_;
  const double right = mouse_.x - from.x, down = mouse_.y - from.y;
  if (drag_ == Drag::kBar) {
    split_ = mouse_.x / size_.width;
    needs_base_ = true;
    return;
  }
  EyeCamera3 camera = camera_;
  const double degrees = kDegreesAcross / size_.height;
  if (drag_ == Drag::kOrbit) {
    camera.orbit(-right * degrees, down * degrees);
  } else if (drag_ == Drag::kTurn) {
    camera.turn(-right * degrees / 2, down * degrees / 2);
  } else {
    const double length = camera_.length_of_pixel(size_);
    camera.pan(-right * length, down * length);
  }
  see(camera);
}

// A click picks what lies under the mouse.
void Desk3::release(const WindowEvent& event) {
  if (drag_ == Drag::kNone || event.button != button_) return;
  const Drag ended = std::exchange(drag_, Drag::kNone);
  touch();
  if (has_moved_ || ended == Drag::kBar || event.button != MouseButton::kLeft) return;
  picked_ = hover_;
  LookRequest3 request = request_;
  request.face = face_of_element(picked_);
  set_request(std::move(request));
}

// The face that an element is of.
std::optional<Face> Desk3::face_of_element(std::optional<std::uint32_t> element) const {
  if (!element || !state().model) return std::nullopt;
  const Element& its = state().model->table.elements()[*element];
  return Face{its.surface, its.is_back};
}

// Picks a polygon by its first element, as it is numbered, that there is something of.
void Desk3::pick(const Face& face) {
  LookRequest3 request = request_;
  request.face = face;
  picked_.reset();
  if (state().model) {
    const ElementTable3& table = state().model->table;
    for (std::uint32_t e = 0; e < table.count() && !picked_; ++e)
      if (table.has_row(e) && face_of_element(e) == face) picked_ = e;
  }
  set_request(std::move(request));
}

}  // namespace hottel
