#include "viewer/window/sdl_window.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "viewer/window/sdl_library.h"

namespace hottel {
namespace {

constexpr int kLongestWait = 50;  // milliseconds, until interrupted() is asked again

using Kind = WindowEvent::Kind;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? std::string(name) + " is not set" : std::string(name) + "=" + value;
}

[[noreturn]] void refuse_without_display(const std::string& reason) {
  const char* driver = std::getenv("SDL_VIDEODRIVER");
  throw RequestError("no window could be opened (SDL: " + reason + "; " + variable("DISPLAY") + ", " +
                     variable("WAYLAND_DISPLAY") + (driver ? ", " + variable("SDL_VIDEODRIVER") : "") +
                     "): a window needs a display; --screenshot, --script and --record need none");
}

// An error that the X server tells, as Xlib hands it to a program (XErrorEvent).
struct XError {
  int type;
  void* display;
  unsigned long resource, serial;
  unsigned char code, request, minor;
};
using XErrorHandler = int (*)(void* display, XError* error);
XErrorHandler of_others = nullptr;

// SDL wakes the thread that waits for events by sending one to its own window, over a connection of its own. When the
// window is closed meanwhile the server may come to that too late, and Xlib would end the program.
int pass_by_late_wakes(void* display, XError* error) {
  constexpr unsigned char kBadWindow = 3, kSendEvent = 25;
  if (error->code == kBadWindow && error->request == kSendEvent) return 0;
  return of_others == nullptr ? 0 : of_others(display, error);
}

// Before SDL begins: it hands errors on to whom it finds then, and leaves them to that one when it ends, before it
// closes its connections. The library stays loaded.
void bear_late_wakes() {
  using SetHandler = XErrorHandler (*)(XErrorHandler);
  void* const xlib = sdl().LoadObject("libX11.so.6");
  if (xlib == nullptr) return;
  if (const auto set = reinterpret_cast<SetHandler>(sdl().LoadFunction(xlib, "XSetErrorHandler"))) {
    const XErrorHandler before = set(pass_by_late_wakes);
    if (before != pass_by_late_wakes) of_others = before;
  }
}

// While it lives, SDL shows and hears.
class Video {
 public:
  Video() {
    HOTTEL_REQUIRE(sdl().WasInit(SDL_INIT_VIDEO) == 0);
    sdl().SetMainReady();
    set_hints();
    bear_late_wakes();
    if (sdl().InitSubSystem(SDL_INIT_VIDEO) != 0) {
      const std::string reason = sdl().GetError();
      sdl().Quit();
      refuse_without_display(reason);
    }
    // These show nothing. SDL may take one when it finds no other; the user may ask for one.
    const std::string_view driver = sdl().GetCurrentVideoDriver();
    const char* asked = std::getenv("SDL_VIDEODRIVER");
    if ((driver == "dummy" || driver == "offscreen") && (asked == nullptr || *asked == '\0')) {
      sdl().Quit();
      refuse_without_display("No available video device");
    }
  }
  ~Video() { sdl().Quit(); }
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

 private:
  static void set_hints() {
    const auto set = [](const char* name, const char* value) {
      sdl().SetHintWithPriority(name, value, SDL_HINT_OVERRIDE);
    };
    set(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    set(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    set(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    set(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");  // the click that brings the window to the front counts
    // On X11 pixels go to the server through shared memory. By OpenGL, where that computes on the processor, a frame of
    // 1280 by 800 takes 8 ms and not 0.7, and the first after a resize is cut to the size before.
    sdl().SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  }
};

template <class T, auto Destroy>
struct Destroyer {
  void operator()(T* object) const { (sdl().*Destroy)(object); }
};
using SdlWindow = std::unique_ptr<SDL_Window, Destroyer<SDL_Window, &Sdl::DestroyWindow>>;
using Renderer = std::unique_ptr<SDL_Renderer, Destroyer<SDL_Renderer, &Sdl::DestroyRenderer>>;
using Texture = std::unique_ptr<SDL_Texture, Destroyer<SDL_Texture, &Sdl::DestroyTexture>>;

[[noreturn]] void refuse(const char* what) {
  throw RequestError(std::string(what) + " (SDL: " + sdl().GetError() + ")");
}

// A character as UTF-8. REQUIRES: one of Unicode's.
std::string utf8(std::uint32_t character) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(bits); };
  const auto tail = [&](int shift) { return byte(0x80 | (character >> shift & 0x3F)); };
  if (character < 0x80) return {byte(character)};
  if (character < 0x800) return {byte(0xC0 | character >> 6), tail(0)};
  if (character < 0x10000) return {byte(0xE0 | character >> 12), tail(6), tail(0)};
  return {byte(0xF0 | character >> 18), tail(12), tail(6), tail(0)};
}

struct NamedKey {
  SDL_Keycode code;
  const char* name;
};

constexpr std::array kKeys{
    NamedKey{SDLK_SPACE, "space"},   NamedKey{SDLK_RETURN, "enter"},        NamedKey{SDLK_ESCAPE, "escape"},
    NamedKey{SDLK_TAB, "tab"},       NamedKey{SDLK_BACKSPACE, "backspace"}, NamedKey{SDLK_DELETE, "delete"},
    NamedKey{SDLK_LEFT, "left"},     NamedKey{SDLK_RIGHT, "right"},         NamedKey{SDLK_UP, "up"},
    NamedKey{SDLK_DOWN, "down"},     NamedKey{SDLK_HOME, "home"},           NamedKey{SDLK_END, "end"},
    NamedKey{SDLK_PAGEUP, "pageup"}, NamedKey{SDLK_PAGEDOWN, "pagedown"},   NamedKey{SDLK_KP_ENTER, "enter"},
    NamedKey{SDLK_KP_DIVIDE, "/"},   NamedKey{SDLK_KP_MULTIPLY, "*"},       NamedKey{SDLK_KP_MINUS, "-"},
    NamedKey{SDLK_KP_PLUS, "+"},     NamedKey{SDLK_KP_EQUALS, "="},
};

// Keys of the keypad: what they type with num lock, and what they do without.
struct KeypadKey {
  SDL_Keycode code;
  const char *typed, *name;
};

constexpr std::array kKeypad{
    KeypadKey{SDLK_KP_0, "0", ""},         KeypadKey{SDLK_KP_1, "1", "end"},         KeypadKey{SDLK_KP_2, "2", "down"},
    KeypadKey{SDLK_KP_3, "3", "pagedown"}, KeypadKey{SDLK_KP_4, "4", "left"},        KeypadKey{SDLK_KP_5, "5", ""},
    KeypadKey{SDLK_KP_6, "6", "right"},    KeypadKey{SDLK_KP_7, "7", "home"},        KeypadKey{SDLK_KP_8, "8", "up"},
    KeypadKey{SDLK_KP_9, "9", "pageup"},   KeypadKey{SDLK_KP_PERIOD, ".", "delete"},
};

// What the key at that place types on a keyboard with Latin letters; empty beside the letters and digits. So letters
// and digits are commands on every keyboard: where digits take shift, and where letters are other than Latin.
std::string latin_key(SDL_Scancode place) {
  if (place == SDL_SCANCODE_0) return "0";
  if (place >= SDL_SCANCODE_1 && place <= SDL_SCANCODE_9)
    return std::string(1, static_cast<char>('1' + (place - SDL_SCANCODE_1)));
  if (place >= SDL_SCANCODE_A && place <= SDL_SCANCODE_Z)
    return std::string(1, static_cast<char>('a' + (place - SDL_SCANCODE_A)));
  return "";
}

bool is_latin(SDL_Keycode key) { return (key >= 'a' && key <= 'z') || (key >= '0' && key <= '9'); }

// The name of a key as WindowEvent has it, empty for those it has not.
std::string key_name(const SDL_Keysym& key) {
  for (const NamedKey& named : kKeys)
    if (named.code == key.sym) return named.name;
  for (const KeypadKey& named : kKeypad)
    if (named.code == key.sym) return key.mod & KMOD_NUM ? named.typed : named.name;
  if (key.sym >= SDLK_F1 && key.sym <= SDLK_F12) return "f" + std::to_string(key.sym - SDLK_F1 + 1);
  const bool is_digit_place = key.scancode >= SDL_SCANCODE_1 && key.scancode <= SDL_SCANCODE_0;
  if (!is_latin(key.sym) && (is_digit_place || key.sym > 0x7F))
    if (std::string latin = latin_key(key.scancode); !latin.empty()) return latin;
  const bool is_character = key.sym > ' ' && key.sym != 0x7F && (key.sym & SDLK_SCANCODE_MASK) == 0;
  return is_character ? utf8(static_cast<std::uint32_t>(key.sym)) : "";
}

MouseButton button_of(Uint8 button) {
  return button == SDL_BUTTON_LEFT     ? MouseButton::kLeft
         : button == SDL_BUTTON_MIDDLE ? MouseButton::kMiddle
         : button == SDL_BUTTON_RIGHT  ? MouseButton::kRight
                                       : MouseButton::kNone;
}

std::optional<WindowEvent> of_window(const SDL_WindowEvent& event) {
  switch (event.event) {
    case SDL_WINDOWEVENT_SIZE_CHANGED:
    case SDL_WINDOWEVENT_EXPOSED:
      return WindowEvent{.kind = Kind::kResize};
    case SDL_WINDOWEVENT_LEAVE:
      return WindowEvent{.kind = Kind::kLeave};
    case SDL_WINDOWEVENT_FOCUS_GAINED:
      return WindowEvent{.kind = Kind::kFocus};
    default:
      return std::nullopt;
  }
}

class ScreenWindow : public Window {
 public:
  ScreenWindow(const std::string& title, FrameSize size) {
    window_.reset(sdl().CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                     static_cast<int>(size.width), static_cast<int>(size.height),
                                     SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
    if (!window_) refuse("no window could be opened");
    std::array<Uint32, 2> ways{SDL_RENDERER_SOFTWARE, SDL_RENDERER_ACCELERATED};
    if (sdl().GetCurrentVideoDriver() != std::string_view("x11")) std::swap(ways[0], ways[1]);
    for (const Uint32 way : ways)
      if (!renderer_) renderer_.reset(sdl().CreateRenderer(window_.get(), -1, way));
    if (!renderer_) refuse("nothing can be drawn in a window");
    wake_type_ = sdl().RegisterEvents(1);
    sdl().StartTextInput();
  }
  ~ScreenWindow() override { sdl().StopTextInput(); }

  FrameSize size() const override {
    int width = 1, height = 1;
    sdl().GetRendererOutputSize(renderer_.get(), &width, &height);
    return {static_cast<std::uint32_t>(std::max(width, 1)), static_cast<std::uint32_t>(std::max(height, 1))};
  }

  std::optional<WindowEvent> next(double seconds) override {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (;;) {
      throw_if_interrupted();
      const double left = 1e3 * (seconds - std::chrono::duration<double>(Clock::now() - start).count());
      const double wait = std::clamp(std::ceil(left), 0.0, static_cast<double>(kLongestWait));
      SDL_Event event;
      if (sdl().WaitEventTimeout(&event, static_cast<int>(wait)) == 0) {
        if (left <= 0) return std::nullopt;
      } else if (auto result = event_of(event)) {
        if (result->kind == Kind::kMove || result->kind == Kind::kResize) take_latest(*result);
        return result;
      }
    }
  }

  void wake() override {
    if (is_woken_.exchange(true)) return;
    SDL_Event event{};
    event.type = wake_type_;
    if (sdl().PushEvent(&event) != 1) is_woken_ = false;
  }

  void show(const Raster& frame) override {
    HOTTEL_REQUIRE(!frame.pixels.empty() && frame.pixels.size() == std::size_t{frame.width} * frame.height);
    const FrameSize size{frame.width, frame.height};
    if (!texture_ || size != texture_size_) make_texture(size);
    const bool is_shown =
        sdl().UpdateTexture(texture_.get(), nullptr, frame.pixels.data(), static_cast<int>(4 * frame.width)) == 0 &&
        sdl().RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr) == 0;
    if (!is_shown) refuse("a frame cannot be shown");
    sdl().RenderPresent(renderer_.get());
  }

  void set_title(std::string_view title) override { sdl().SetWindowTitle(window_.get(), std::string(title).c_str()); }
  void set_clipboard(std::string_view text) override { sdl().SetClipboardText(std::string(text).c_str()); }

 private:
  void make_texture(FrameSize size) {
    texture_.reset(sdl().CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING,
                                       static_cast<int>(size.width), static_cast<int>(size.height)));
    if (!texture_ || sdl().SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE) != 0)
      refuse("a frame cannot be shown");
    texture_size_ = size;
  }

  // Replaces the event by the last of those of its kind that wait next.
  void take_latest(WindowEvent& result) {
    sdl().PumpEvents();
    SDL_Event event;
    while (sdl().PeepEvents(&event, 1, SDL_PEEKEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT) == 1) {
      const bool is_mark = event.type == SDL_POLLSENTINEL;  // of SDL's own
      const bool is_move = event.type == SDL_MOUSEMOTION && result.kind == Kind::kMove;
      const bool is_resize = event.type == SDL_WINDOWEVENT && result.kind == Kind::kResize &&
                             (event.window.event == SDL_WINDOWEVENT_RESIZED ||
                              of_window(event.window).value_or(WindowEvent{}).kind == Kind::kResize);
      if (!is_mark && !is_move && !is_resize) return;
      sdl().PeepEvents(&event, 1, SDL_GETEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT);
      if (is_move) result = *event_of(event);
    }
  }

  // What an event of SDL is to the user of the window; nothing for most.
  std::optional<WindowEvent> event_of(const SDL_Event& event) {
    if (event.type == wake_type_) {
      is_woken_ = false;
      return WindowEvent{.kind = Kind::kWake};
    }
    switch (event.type) {
      case SDL_QUIT:
        return WindowEvent{.kind = Kind::kQuit};
      case SDL_WINDOWEVENT:
        return of_window(event.window);
      case SDL_RENDER_DEVICE_RESET:
        texture_.reset();
        return WindowEvent{.kind = Kind::kResize};
      case SDL_MOUSEMOTION:
        return at_mouse(Kind::kMove, event.motion.x, event.motion.y);
      case SDL_MOUSEBUTTONDOWN:
      case SDL_MOUSEBUTTONUP:
        return of_button(event.button);
      case SDL_MOUSEWHEEL:
        return of_wheel(event.wheel);
      case SDL_KEYDOWN:
      case SDL_KEYUP:
        return of_key(event.key);
      case SDL_TEXTINPUT:
        if (held_.ctrl || held_.alt) return std::nullopt;
        return WindowEvent{.kind = Kind::kText, .text = event.text.text, .held = held_};
      default:
        return std::nullopt;
    }
  }

  WindowEvent at_mouse(Kind kind, int x, int y) {
    int width = 0, height = 0;
    sdl().GetWindowSize(window_.get(), &width, &height);
    const FrameSize frame = size();
    mouse_x_ = x * (width > 0 ? frame.width / static_cast<double>(width) : 1);
    mouse_y_ = y * (height > 0 ? frame.height / static_cast<double>(height) : 1);
    return {.kind = kind, .x = mouse_x_, .y = mouse_y_, .held = held_};
  }

  std::optional<WindowEvent> of_button(const SDL_MouseButtonEvent& event) {
    const Kind kind = event.type == SDL_MOUSEBUTTONDOWN ? Kind::kPress : Kind::kRelease;
    WindowEvent result = at_mouse(kind, event.x, event.y);
    result.button = button_of(event.button);
    if (result.button == MouseButton::kNone) return std::nullopt;
    return result;
  }

  std::optional<WindowEvent> of_wheel(const SDL_MouseWheelEvent& event) const {
    const double notches = event.direction == SDL_MOUSEWHEEL_FLIPPED ? -event.preciseY : event.preciseY;
    if (notches == 0) return std::nullopt;  // sideways
    return WindowEvent{.kind = Kind::kWheel, .x = mouse_x_, .y = mouse_y_, .wheel = notches, .held = held_};
  }

  std::optional<WindowEvent> of_key(const SDL_KeyboardEvent& event) {
    // Held keys are those of the queue's time, not of the keyboard's. On many keyboards the right Alt types letters.
    const auto holds = [&](int keys) { return (event.keysym.mod & keys) != 0; };
    held_ = {.shift = holds(KMOD_SHIFT), .ctrl = holds(KMOD_CTRL), .alt = holds(KMOD_LALT)};
    std::string name = event.type == SDL_KEYDOWN ? key_name(event.keysym) : "";
    if (name.empty()) return std::nullopt;
    return WindowEvent{.kind = Kind::kKey, .x = mouse_x_, .y = mouse_y_, .key = std::move(name), .held = held_};
  }

  Video video_;
  SdlWindow window_;
  Renderer renderer_;
  Texture texture_;
  FrameSize texture_size_;
  Uint32 wake_type_ = 0;
  std::atomic<bool> is_woken_{false};  // a kWake is on its way
  double mouse_x_ = 0, mouse_y_ = 0;
  HeldKeys held_;
};

}  // namespace

std::unique_ptr<Window> open_window(const std::string& title, FrameSize size) {
  return std::make_unique<ScreenWindow>(title, size);
}

}  // namespace hottel
