// A window, or what stands for one: events come in, frames go out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/picture/raster.h"

namespace hottel {

// What was held down while something happened.
struct HeldKeys {
  bool shift = false, ctrl = false, alt = false;
  friend bool operator==(const HeldKeys&, const HeldKeys&) = default;
};

enum class MouseButton : unsigned char { kNone, kLeft, kMiddle, kRight };

// Something that happened to a window.
struct WindowEvent {
  enum class Kind : unsigned char {
    kQuit,     // the window is asked to close
    kResize,   // size() has changed, or what was shown is lost: show again
    kMove,     // the mouse is at (x, y), whatever is held down
    kLeave,    // the mouse left the window
    kPress,    // a button went down, or up
    kRelease,  //
    kWheel,    // `wheel` notches, away from the user is positive
    kKey,      // a key went down, or repeats
    kText,     // text was typed; a key that types text sends a kKey first
    kFocus,    // the window has the keyboard again
    kWake,     // Window::wake() was called
  };

  Kind kind = Kind::kWake;
  double x = 0, y = 0;  // of the mouse, in pixels of a frame; of kMove, kPress, kRelease, kWheel
  MouseButton button = MouseButton::kNone;
  double wheel = 0;
  // What the key types without held keys ("a", "1", "[", "space"), by its place on a Latin keyboard where that is
  // neither a Latin letter nor a digit and the place has one; or is called: "enter", "escape", "tab", "backspace",
  // "delete", "left", "right", "up", "down", "home", "end", "pageup", "pagedown", "f1" to "f12". Lower case.
  std::string key = {};
  std::string text = {};  // UTF-8
  HeldKeys held = {};
};

// The size of a frame in pixels.
struct FrameSize {
  std::uint32_t width = 0, height = 0;
  friend bool operator==(const FrameSize&, const FrameSize&) = default;
};

// Used by the thread that made it, but for wake().
class Window {
 public:
  virtual ~Window() = default;

  // The size that the next frame should have; at least one pixel.
  virtual FrameSize size() const = 0;
  // Returns the next event, waiting for it as many seconds at most; nothing where none came. Throws Interrupted within
  // a tenth of a second where a stop was asked for (kernel/support/interrupt.h).
  virtual std::optional<WindowEvent> next(double seconds) = 0;
  // Makes next() return a kWake soon, now or when it is called; several calls may give one. Any thread may call it.
  virtual void wake() = 0;
  // Shows a frame, stretched where it is not of the window's size.
  virtual void show(const Raster& frame) = 0;
  virtual void set_title(std::string_view title) = 0;
  virtual void set_clipboard(std::string_view text) = 0;
};

}  // namespace hottel
