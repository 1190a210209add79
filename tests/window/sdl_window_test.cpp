// A window on a real screen, with a window manager, under hands.
#include "viewer/window/sdl_window.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "tests/window/xvfb.h"

namespace hottel::sdl_window_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing_window::ScopedVariable;
using testing_window::XvfbSession;
using Kind = WindowEvent::Kind;
using Clock = std::chrono::steady_clock;

constexpr double kPatience = 20;  // seconds, until what must come is taken to be missing
constexpr FrameSize kSize{640, 400};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Every pixel tells where it is.
Raster chart(FrameSize size) {
  Raster raster(size.width, size.height);
  for (std::uint32_t y = 0; y < size.height; ++y)
    for (std::uint32_t x = 0; x < size.width; ++x)
      raster.pixels[std::size_t{y} * size.width + x] =
          0xFF000000 | (x & 0xFF) << 16 | (y & 0xFF) << 8 | (x >> 8) << 4 | y >> 8;
  return raster;
}

// A window on a screen of its own, with the keyboard, under no mouse.
class SdlWindow : public testing::Test {
 protected:
  SdlWindow() {
    session_.xdotool("mousemove 1390 990");
    open();
  }

  void open() {
    window_ = open_window("hottel test", kSize);
    id_ = session_.window("^hottel test$");
    session_.xdotool("windowactivate --sync " + id_);
    session_.xdotool("windowfocus --sync " + id_);
    settle();
  }

  // The first event that fits, which must come; those before it are dropped.
  WindowEvent expect(const std::function<bool(const WindowEvent&)>& fits) {
    const auto start = Clock::now();
    while (seconds_since(start) < kPatience)
      if (const auto event = window_->next(1); event && fits(*event)) return *event;
    ADD_FAILURE() << "the event has not come";
    return {};
  }
  WindowEvent expect(Kind kind) {
    return expect([kind](const WindowEvent& event) { return event.kind == kind; });
  }

  // Drops events until none has come for a while, which must be soon.
  void settle() {
    const auto start = Clock::now();
    while (window_->next(0.3))
      if (seconds_since(start) > kPatience) throw std::runtime_error("events do not end");
  }

  // The keys and texts that a hand on the keyboard gives, one after the other: "key a", "text A".
  std::vector<std::string> typed(const std::string& words) {
    session_.xdotool(words);
    session_.xdotool("key F12");
    std::vector<std::string> result;
    for (;;) {
      const WindowEvent event =
          expect([](const WindowEvent& e) { return e.kind == Kind::kKey || e.kind == Kind::kText; });
      if (event.key == "f12" || testing::Test::HasFailure()) return result;
      const std::string held = std::string(event.held.shift ? "shift+" : "") + (event.held.ctrl ? "ctrl+" : "") +
                               (event.held.alt ? "alt+" : "");
      result.push_back(event.kind == Kind::kKey ? "key " + held + event.key : "text " + event.text);
    }
  }

  XvfbSession session_;
  std::unique_ptr<Window> window_;
  std::string id_;
};

TEST_F(SdlWindow, HasTheSizeAndTitleAskedFor) {
  EXPECT_EQ(window_->size(), kSize);
  EXPECT_EQ(session_.xdotool("getwindowname " + id_), "hottel test");
  window_->set_title("a \xc3\xa9");
  EXPECT_EQ(session_.xdotool("getwindowname " + id_), "a \xc3\xa9");
}

TEST_F(SdlWindow, ShowsWhatItIsGiven) {
  const Raster frame = chart(kSize);
  window_->show(frame);
  settle();
  window_->show(frame);
  EXPECT_TRUE(session_.grab(id_) == frame);
  // Another size is stretched.
  window_->show(Raster(7, 5, 0xFF204060));
  EXPECT_TRUE(session_.grab(id_) == Raster(kSize.width, kSize.height, 0xFF204060));
  Raster broken(7, 5);
  broken.pixels.pop_back();
  EXPECT_THROW(window_->show(broken), ContractViolation);
  EXPECT_THROW(window_->show(Raster()), ContractViolation);
}

TEST_F(SdlWindow, IsSeenOnTheScreen) {
  const Raster frame = chart(kSize);
  window_->show(frame);
  const Raster screen = session_.screen();
  // "X=380", and so on.
  std::map<std::string, std::uint32_t> place;
  std::istringstream lines(session_.xdotool("mousemove --window " + id_ + " 0 0 getmouselocation --shell"));
  for (std::string line; std::getline(lines, line);)
    place[line.substr(0, line.find('='))] = static_cast<std::uint32_t>(std::stoul(line.substr(line.find('=') + 1)));
  ASSERT_LE(place.at("X") + kSize.width, screen.width);
  ASSERT_LE(place.at("Y") + kSize.height, screen.height);
  for (std::uint32_t y = 0; y < kSize.height; ++y)
    for (std::uint32_t x = 0; x < kSize.width; ++x)
      ASSERT_EQ(screen.pixels[std::size_t{place["Y"] + y} * screen.width + place["X"] + x],
                frame.pixels[std::size_t{y} * kSize.width + x])
          << x << " " << y;
}

TEST_F(SdlWindow, TellsWhereTheMouseIs) {
  session_.xdotool("mousemove --window " + id_ + " 100 50");
  WindowEvent event = expect(Kind::kMove);
  EXPECT_EQ(event.x, 100);
  EXPECT_EQ(event.y, 50);
  EXPECT_EQ(event.held, HeldKeys{});
  session_.xdotool("mousemove 1390 990");
  expect(Kind::kLeave);
}

TEST_F(SdlWindow, MovesThatWaitBecomeTheLast) {
  session_.xdotool("mousemove --window " + id_ + " 1 1");
  settle();
  std::string words;
  for (int k = 0; k < 50; ++k) words += "mousemove --window " + id_ + " " + std::to_string(100 + k) + " 60 ";
  session_.xdotool(words);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  int moves = 0;
  WindowEvent last;
  while (const auto event = window_->next(0.3))
    if (event->kind == Kind::kMove) {
      ++moves;
      last = *event;
    }
  EXPECT_EQ(last.x, 149);
  EXPECT_LE(moves, 2);
}

TEST_F(SdlWindow, TellsOfButtons) {
  const std::pair<int, MouseButton> buttons[] = {
      {1, MouseButton::kLeft}, {2, MouseButton::kMiddle}, {3, MouseButton::kRight}};
  session_.xdotool("mousemove --window " + id_ + " 200 300");
  for (const auto& [number, button] : buttons) {
    session_.xdotool("click " + std::to_string(number));
    for (const Kind kind : {Kind::kPress, Kind::kRelease}) {
      const WindowEvent event =
          expect([](const WindowEvent& e) { return e.kind == Kind::kPress || e.kind == Kind::kRelease; });
      EXPECT_EQ(event.kind, kind);
      EXPECT_EQ(event.button, button);
      EXPECT_EQ(event.x, 200);
      EXPECT_EQ(event.y, 300);
      EXPECT_EQ(event.held, HeldKeys{});
    }
  }
}

TEST_F(SdlWindow, ADragGoesOnOutside) {
  session_.xdotool("mousemove --window " + id_ + " 10 20 mousedown 1");
  EXPECT_EQ(expect(Kind::kPress).x, 10);
  session_.xdotool("mousemove --window " + id_ + " 700 420");
  const WindowEvent moved = expect([](const WindowEvent& e) { return e.kind == Kind::kMove && e.x != 10; });
  EXPECT_EQ(moved.x, 700);
  EXPECT_EQ(moved.y, 420);
  session_.xdotool("mouseup 1");
  EXPECT_EQ(expect(Kind::kRelease).y, 420);
}

TEST_F(SdlWindow, TellsOfTheWheelAndWhereItIs) {
  session_.xdotool("mousemove --window " + id_ + " 33 44");
  for (const auto& [button, notches] : {std::pair{4, 1.0}, {5, -1.0}}) {
    session_.xdotool("click " + std::to_string(button));
    const WindowEvent event = expect(Kind::kWheel);
    EXPECT_EQ(event.wheel, notches);
    EXPECT_EQ(event.x, 33);
    EXPECT_EQ(event.y, 44);
  }
}

TEST_F(SdlWindow, TellsOfKeysHeldWithTheMouse) {
  session_.xdotool("mousemove --window " + id_ +
                   " 33 44 keydown shift keydown ctrl click 1 keyup ctrl click 4 keyup shift");
  EXPECT_EQ(expect(Kind::kPress).held, (HeldKeys{.shift = true, .ctrl = true}));
  EXPECT_EQ(expect(Kind::kWheel).held, (HeldKeys{.shift = true}));
  session_.xdotool("mousemove --window " + id_ + " 35 44");
  EXPECT_EQ(expect(Kind::kMove).held, HeldKeys{});
}

TEST_F(SdlWindow, NamesKeysByWhatTheyTypeAlone) {
  EXPECT_THAT(typed("key a"), ElementsAre("key a", "text a"));
  EXPECT_THAT(typed("key shift+a"), ElementsAre("key shift+a", "text A"));
  EXPECT_THAT(typed("key shift+1"), ElementsAre("key shift+1", "text !"));
  EXPECT_THAT(typed("key bracketleft"), ElementsAre("key [", "text ["));
  EXPECT_THAT(typed("key space"), ElementsAre("key space", "text  "));
  EXPECT_THAT(typed("key ctrl+z"), ElementsAre("key ctrl+z"));
  EXPECT_THAT(typed("key ctrl+shift+z"), ElementsAre("key shift+ctrl+z"));
  EXPECT_THAT(typed("key ctrl+1 key alt+x"), ElementsAre("key ctrl+1", "key alt+x"));
  EXPECT_THAT(typed("key ctrl+plus"), ElementsAre("key shift+ctrl+="));
}

TEST_F(SdlWindow, NamesKeysThatTypeNothing) {
  EXPECT_THAT(typed("key Return key Escape key Tab key BackSpace key Delete"),
              ElementsAre("key enter", "key escape", "key tab", "key backspace", "key delete"));
  EXPECT_THAT(typed("key Left key Right key Up key Down"), ElementsAre("key left", "key right", "key up", "key down"));
  EXPECT_THAT(typed("key Home key End key Prior key Next"),
              ElementsAre("key home", "key end", "key pageup", "key pagedown"));
  EXPECT_THAT(typed("key F1 key F11 key shift+F5 key alt+Left"),
              ElementsAre("key f1", "key f11", "key shift+f5", "key alt+left"));
  EXPECT_THAT(typed("key shift+Tab"), ElementsAre("key shift+tab"));
  EXPECT_THAT(typed("key KP_Enter key KP_Add key KP_Left"), ElementsAre("key enter", "key +", "text +", "key left"));
  EXPECT_THAT(typed("key shift key ctrl key Print"), ElementsAre());
}

TEST_F(SdlWindow, TextComesAsTyped) {
  std::string text;
  for (const std::string& event : typed("type --delay 20 'Wall 2,5 [a-Z]!'"))
    if (event.starts_with("text ")) text += event.substr(5);
  EXPECT_EQ(text, "Wall 2,5 [a-Z]!");
}

TEST_F(SdlWindow, KeysAreThoseOfTheLayout) {
  session_.set_keyboard("fr");
  settle();
  EXPECT_THAT(typed("key a key shift+a"), ElementsAre("key a", "text a", "key shift+a", "text A"));
  // Digits are digits, also where they need Shift.
  EXPECT_THAT(typed("key eacute key 2"), ElementsAre("key 2", "text \xc3\xa9", "key shift+2", "text 2"));
  session_.set_keyboard("de");
  settle();
  EXPECT_THAT(typed("key udiaeresis key y"), ElementsAre("key \xc3\xbc", "text \xc3\xbc", "key y", "text y"));
  // With AltGr, which is no Alt.
  EXPECT_THAT(typed("key bracketleft"), ElementsAre("key 8", "text ["));
  // Where letters are other than Latin they go by their places; what they type stays.
  session_.set_keyboard("ru");
  settle();
  EXPECT_THAT(typed("key Cyrillic_er"), ElementsAre("key h", "text \xd1\x80"));
  EXPECT_THAT(typed("key ctrl+Cyrillic_ya"), ElementsAre("key ctrl+z"));
  // Where digits take Shift they are keys without it.
  session_.set_keyboard("cz");
  settle();
  EXPECT_THAT(typed("key scaron"), ElementsAre("key 3", "text \xc5\xa1"));
}

TEST_F(SdlWindow, AResizeGivesAnEventAndTheNewSize) {
  session_.xdotool("windowsize --sync " + id_ + " 800 500");
  expect([&](const WindowEvent& e) { return e.kind == Kind::kResize && window_->size() != kSize; });
  settle();
  EXPECT_EQ(window_->size(), (FrameSize{800, 500}));
  const Raster frame = chart({800, 500});
  window_->show(frame);
  EXPECT_TRUE(session_.grab(id_) == frame);
  session_.xdotool("mousemove --window " + id_ + " 790 490");
  EXPECT_EQ(expect(Kind::kMove).x, 790);
}

TEST_F(SdlWindow, WhatWasCoveredIsToBeShownAgain) {
  session_.xdotool("windowunmap --sync " + id_);
  settle();
  session_.xdotool("windowmap --sync " + id_);
  expect(Kind::kResize);
  expect(Kind::kFocus);
}

// On a busy machine the window manager may not yet listen to keys when it shows the window: they are pressed again.
TEST_F(SdlWindow, TheWindowManagerAsksItToClose) {
  bool has_asked = false;
  for (const auto start = Clock::now(); !has_asked && seconds_since(start) < kPatience;) {
    session_.xdotool("key alt+F4");
    for (bool has_come = true; has_come && !has_asked;) {
      const auto event = window_->next(2);
      has_come = event.has_value();
      has_asked = has_come && event->kind == Kind::kQuit;
    }
  }
  ASSERT_TRUE(has_asked);
  // It is the program that closes it.
  window_->show(Raster(4, 4));
  window_->set_title("still here");
  EXPECT_EQ(session_.window("^still here$"), id_);
}

TEST_F(SdlWindow, GoesAndComesAgain) {
  window_.reset();
  EXPECT_THROW(session_.xdotool("getwindowname " + id_ + " 2>&1"), std::runtime_error);
  open();
  EXPECT_EQ(window_->size(), kSize);
  EXPECT_THROW(open_window("a second one", kSize), ContractViolation);
}

TEST_F(SdlWindow, WakesFromAnotherThreadOnceForAll) {
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    for (int k = 0; k < 1000; ++k) window_->wake();
  });
  const auto event = window_->next(kPatience);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->kind, Kind::kWake);
  other.join();
  int more = 0;
  while (window_->next(0.1)) ++more;
  EXPECT_LE(more, 20);  // those that were called after the first had been returned
  for (int k = 0; k < 1000; ++k) window_->wake();
  ASSERT_TRUE(window_->next(1));
  EXPECT_FALSE(window_->next(0.1));
}

TEST_F(SdlWindow, WaitsAsLongAsAsked) {
  const auto start = Clock::now();
  EXPECT_FALSE(window_->next(0.12));
  EXPECT_GE(seconds_since(start), 0.12);
  EXPECT_FALSE(window_->next(0));
  EXPECT_FALSE(window_->next(-1));
  EXPECT_LT(seconds_since(start), kPatience);
}

TEST_F(SdlWindow, StopsWaitingWhenAStopIsAskedFor) {
  std::atomic<bool> stop{false};
  const StopScope scope(&stop);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop = true;
  });
  const auto start = Clock::now();
  EXPECT_THROW(window_->next(kPatience), Interrupted);
  EXPECT_LT(seconds_since(start), kPatience);
  other.join();
}

volatile std::sig_atomic_t interrupts = 0;

TEST_F(SdlWindow, LeavesSignalsToTheProgram) {
  interrupts = 0;
  const auto before = std::signal(SIGINT, [](int) { interrupts = interrupts + 1; });
  std::raise(SIGINT);
  EXPECT_EQ(interrupts, 1);
  while (const auto event = window_->next(0.2)) EXPECT_NE(event->kind, Kind::kQuit);
  std::signal(SIGINT, before);
  struct sigaction of_terminate {};
  sigaction(SIGTERM, nullptr, &of_terminate);
  EXPECT_EQ(of_terminate.sa_handler, SIG_DFL);
}

TEST(OpenWindow, SaysThatThereIsNoDisplay) {
  const ScopedVariable display("DISPLAY", std::nullopt), wayland("WAYLAND_DISPLAY", std::nullopt),
      driver("SDL_VIDEODRIVER", std::nullopt);
  const auto open = [] { open_window("title", kSize); };
  EXPECT_THAT(open, testing::ThrowsMessage<RequestError>(
                        AllOf(HasSubstr("no window could be opened"), HasSubstr("DISPLAY is not set"),
                              HasSubstr("WAYLAND_DISPLAY is not set"), HasSubstr("a window needs a display"),
                              HasSubstr("--screenshot, --script and --record need none"), Not(HasSubstr("\n")))));
  const ScopedVariable nowhere("DISPLAY", ":54321");
  EXPECT_THAT(open, testing::ThrowsMessage<RequestError>(HasSubstr("DISPLAY=:54321")));
  const ScopedVariable unknown("SDL_VIDEODRIVER", "no-such-driver");
  EXPECT_THAT(open, testing::ThrowsMessage<RequestError>(HasSubstr("SDL_VIDEODRIVER=no-such-driver")));
}

TEST(OpenWindow, ADriverThatShowsNothingMustBeAskedFor) {
  const ScopedVariable display("DISPLAY", std::nullopt), wayland("WAYLAND_DISPLAY", std::nullopt),
      driver("SDL_VIDEODRIVER", "dummy");
  const auto window = open_window("title", kSize);
  window->show(chart(kSize));
  EXPECT_EQ(window->size(), kSize);
}

}  // namespace
}  // namespace hottel::sdl_window_test
