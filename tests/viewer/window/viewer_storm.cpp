#include "tests/viewer/window/viewer_storm.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <thread>

#include "geometry/space/scene/division.h"
#include "io/files/text_file.h"
#include "io/scene/scene_json.h"
#include "tests/temporary_folder.h"
#include "viewer/window/commands.h"
#include "viewer/window/plane/viewer.h"
#include "viewer/window/recording_window.h"
#include "viewer/window/space/commands.h"
#include "viewer/window/space/viewer.h"

namespace hottel::viewer_storm {
namespace {

using Kind = WindowEvent::Kind;

constexpr double kPatience = 600;             // seconds, for light at rest
constexpr std::uint64_t kBetweenRests = 500;  // events

// Rooms with lights that stand, turn and walk, and surfaces that lie in each other: those of `rug` and `floor` agree as
// long as their materials do the same.
constexpr const char* kRoom3 = R"({"hottel": 1, "dimension": 3,
  "materials": {"white": {"reflectivity": 0.5}, "pale": {"reflectivity": 0.5},
                "lamp": {"emission": 4, "reflectivity": 0.1}, "red": {"reflectivity": [0.6, 0.1, 0.1]}},
  "polygons": [
    {"name": "floor", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "white", "elements": 2},
    {"name": "rug", "points": [[0.2,0.2,0],[0.8,0.2,0],[0.8,0.8,0],[0.2,0.8,0]], "material": "pale"},
    {"name": "ceiling", "points": [[0,0,2],[0,2,2],[2,2,2],[2,0,2]], "material": "white"},
    {"name": "front", "points": [[0,0,0],[0,0,2],[2,0,2],[2,0,0]], "material": "white"},
    {"name": "rear", "points": [[0,2,0],[2,2,0],[2,2,2],[0,2,2]], "material": "pale"},
    {"name": "left", "points": [[0,0,0],[0,2,0],[0,2,2],[0,0,2]], "material": "red"},
    {"name": "right", "points": [[2,0,0],[2,0,2],[2,2,2],[2,2,0]], "material": "white", "elements": 2},
    {"name": "lamp", "points": [[0.5,0.5,1.9],[0.5,1,1.9],[1,1,1.9],[1,0.5,1.9]], "material": "lamp"},
    {"name": "box.bottom", "group": "box", "points": [[1,1.2,0],[1,1.6,0],[1.4,1.6,0],[1.4,1.2,0]], "material": "pale"},
    {"name": "box.top", "group": "box", "points": [[1,1.2,0.4],[1.4,1.2,0.4],[1.4,1.6,0.4],[1,1.6,0.4]], "material": "pale"},
    {"name": "box.a", "group": "box", "points": [[1,1.2,0],[1.4,1.2,0],[1.4,1.2,0.4],[1,1.2,0.4]], "material": "pale"},
    {"name": "box.b", "group": "box", "points": [[1.4,1.2,0],[1.4,1.6,0],[1.4,1.6,0.4],[1.4,1.2,0.4]], "material": "pale"},
    {"name": "box.c", "group": "box", "points": [[1.4,1.6,0],[1,1.6,0],[1,1.6,0.4],[1.4,1.6,0.4]], "material": "pale"},
    {"name": "box.d", "group": "box", "points": [[1,1.6,0],[1,1.2,0],[1,1.2,0.4],[1,1.6,0.4]], "material": "pale"}],
  "lights": [
    {"type": "spot", "name": "torch", "position": [1, 1.4, 1.2], "direction": [0, 0, -1], "focus": 30, "power": 5},
    {"type": "point", "name": "bulb", "power": [2, 1, 1],
     "path": {"points": [[0.4, 1.2, 1], [0.4, 1.6, 1]], "seconds": 2, "closed": true}}],
  "camera": {"eye": [0.9, 0.1, 1.1], "target": [1, 2, 0.9], "field_of_view": 80, "pixels": [800, 600]}})";

constexpr const char* kOther3 = R"({"hottel": 1, "dimension": 3,
  "materials": {"m": {"reflectivity": 0.5, "emission": [1, 0, 1]}},
  "polygons": [{"name": "a", "points": [[0,0,0],[1,0,0],[0,1,0]], "material": "m", "elements": 3},
               {"name": "b", "points": [[0,0,1],[0,1,1],[1,0,1]], "material": "m", "back": "m"}]})";

constexpr const char* kRoom2 = R"({"hottel": 1, "dimension": 2,
  "materials": {"white": {"reflectivity": 0.7}, "lamp": {"emission": [3, 2, 1]}, "red": {"reflectivity": [0.7, 0.1, 0.1]}},
  "edges": [{"name": "screen", "points": [[1, 1], [1, 2]], "material": "white", "back": "red"}],
  "polylines": [
    {"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "material": "white", "closed": true},
    {"name": "step", "points": [[4, 0.5], [3, 0.5], [3, 0]], "material": "lamp", "elements": 2, "behind": "solid"},
    {"name": "table", "points": [[2, 1], [3, 1], [3, 2], [2, 2]], "material": "red", "closed": true}],
  "lights": [
    {"type": "spot", "name": "torch", "position": [1.5, 1.5], "direction": [0, 1], "focus": 30, "power": 3, "rotation": 90},
    {"type": "point", "name": "bulb", "power": [2, 1, 1],
     "path": {"points": [[0.4, 1.2], [0.4, 1.6]], "seconds": 2, "closed": true}}],
  "grid": {"min": [0, 0], "max": [4, 3], "cells": [40, 30]}})";

constexpr const char* kOther2 =
    R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
  "edges": [{"name": "a", "points": [[0, 0], [1, 0]], "material": "m"},
            {"name": "b", "points": [[1, 1], [0, 1]], "material": "m", "back": "m"}],
  "grid": {"min": [0, 0], "max": [1, 1], "cells": [4, 4]}})";

// What is typed into questions: materials that are alike and are not, places, names, nonsense.
constexpr std::array kTexts{"reflectivity 0.5",
                            "reflectivity 0.5; emission 0",
                            "reflectivity 0.1; emission 4",
                            "reflectivity 0.6 0.1 0.1",
                            "emission 1/3",
                            "emission 0 2 0; reflectivity 0.5",
                            "reflectivity 1",
                            "reflectivity 0; emission 0",
                            "emission -1",
                            "power 3; focus 2",
                            "power 1 2 3; rotation 30",
                            "falloff 1",
                            "1,1.4,1",
                            "1, 1",
                            "0.5,0.5,0",
                            "-3,1/3",
                            "1e9, 1e9",
                            "1e300,0,0",
                            "",
                            "\xC3\xA4\xE2\x82\xAC",
                            "0",
                            ";",
                            "name"};
constexpr std::array kOtherKeys{"home", "end",    "f1",       "f12",       "\xC3\xA4", "0",
                                "9",    "ctrl+u", "alt+left", "shift+tab", "enter",    "escape"};

// A viewer, whatever its dimension, with what storms ask of it.
struct StormViewer {
  std::unique_ptr<Viewer> viewer;
  std::function<const std::optional<Prompt>&()> prompt;
  std::function<std::string()> written;  // the scene as a file has it; throws what writing throws
  std::function<bool()> has_problem;
  std::function<std::string()> shape;  // where the corners are
};

std::string corners_text(const Viewer2& viewer) {
  std::string text;
  for (const Edge2& edge : viewer.editor().scene()->edges)
    for (const Point2& p : {edge.from, edge.to}) text += to_string(p.x) + "," + to_string(p.y) + ";";
  return text;
}
std::string corners_text(const Viewer3& viewer) {
  std::string text;
  for (const Polygon3& polygon : viewer.scene()->polygons)
    for (const Point3& p : corners_of(polygon))
      text += to_string(p.x) + "," + to_string(p.y) + "," + to_string(p.z) + ";";
  return text;
}

StormViewer viewer_on(const StormOptions& options, const std::filesystem::path& file, Window& window) {
  if (options.dimension == 2) {
    auto viewer = std::make_unique<Viewer2>(file, window, SimulationRequest2{}, 1.0);
    Viewer2* const its = viewer.get();
    return {std::move(viewer), [its]() -> const std::optional<Prompt>& { return its->prompt(); },
            [its] {
              validate(*its->editor().scene());
              return write_scene_2(*its->editor().scene());
            },
            [its] { return !its->views().state().problem.empty(); }, [its] { return corners_text(*its); }};
  }
  const auto read = [file, n = options.elements] {
    Scene3 scene = read_scene_3(file);
    if (n > 1) divide_into(scene, n);
    return scene;
  };
  auto viewer = std::make_unique<Viewer3>(ViewerSource3{file, read}, window, FactorsRequest3{}, 1.0);
  Viewer3* const its = viewer.get();
  return {std::move(viewer), [its]() -> const std::optional<Prompt>& { return its->prompt(); },
          [its] { return write_scene_3(*its->scene()); }, [its] { return !its->state().problem.empty(); },
          [its] { return corners_text(*its); }};
}

class Storm {
 public:
  explicit Storm(const StormOptions& options)
      : options_(options), random_(options.seed), window_({options.most_width, options.most_height}) {
    first_ = !options.scene.empty() ? read_text_file(options.scene) : options.dimension == 2 ? kRoom2 : kRoom3;
    write(first_);
    watch();
  }

  StormResult run() {
    std::string what;
    try {
      begin();
      while (result_.events < options_.events && result_.failures.empty()) {
        what = "event";
        batch();
        if (result_.events / kBetweenRests != rests_ || result_.events >= options_.events) {
          what = "rest";
          rests_ = result_.events / kBetweenRests;
          rest();
        }
      }
    } catch (const std::exception& error) {
      fail(what + " throws: " + error.what() + ", after " + last_);
    }
    viewer_ = {};
    return result_;
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  bool one_in(std::uint64_t n) { return below(n) == 0; }
  template <class List>
  auto any_of(const List& list) {
    return list[below(std::size(list))];
  }
  void fail(const std::string& what) {
    result_.failures.push_back("seed " + std::to_string(options_.seed) + ", event " + std::to_string(result_.events) +
                               ": " + what);
  }
  std::filesystem::path file() const { return folder_ / "scene.json"; }
  void write(const std::string& text) const { std::ofstream(file()) << text; }
  void watch() {
    window_.on_frame([this](const Raster& frame) {
      ++result_.frames;
      const FrameSize size = window_.size();
      if (frame.width != size.width || frame.height != size.height) fail("a frame has another size than the window");
    });
  }

  void begin() {
    ++result_.viewers;
    write(first_);
    viewer_ = viewer_on(options_, file(), window_);
    is_changed_on_disk_ = false;
  }

  // Some events, as the loop of a window takes them, and time for what runs beside.
  void batch() {
    const std::uint64_t count = 1 + below(one_in(4) ? 30 : 4);
    for (std::uint64_t k = 0; k < count && result_.events < options_.events; ++k) {
      if (one_in(40) && !viewer_.prompt()) rewrite();
      event();
      if (viewer_.viewer->wants_quit()) begin();
    }
    viewer_.viewer->pass_time(one_in(2) ? Rational(1, 50) : Rational(0));
    if (!one_in(5)) viewer_.viewer->update();
    if (viewer_.has_problem()) ++result_.problems;
    if (one_in(3)) std::this_thread::sleep_for(std::chrono::microseconds(below(one_in(8) ? 30000 : 2000)));
  }

  void handle(const WindowEvent& event) {
    ++result_.events;
    last_ = text_of(event);
    viewer_.viewer->handle(event);
  }
  static std::string text_of(const WindowEvent& event) {
    return "kind " + std::to_string(static_cast<int>(event.kind)) + " key '" + key_text(event) + "' text '" +
           event.text + "' at " + std::to_string(event.x) + "," + std::to_string(event.y);
  }

  HeldKeys some_held() { return {.shift = one_in(5), .ctrl = one_in(5), .alt = one_in(12)}; }
  // A place in the window, or a little beside it.
  WindowEvent at_place(Kind kind) {
    const FrameSize size = window_.size();
    WindowEvent event{.kind = kind, .held = some_held()};
    std::uniform_real_distribution<double> across(-0.05, 1.05);
    event.x = std::floor(across(random_) * size.width);
    event.y = std::floor(across(random_) * size.height);
    if (one_in(4)) {  // at a corner or a light, where there is more to be held
      event.x = last_x_;
      event.y = last_y_;
    }
    last_x_ = event.x;
    last_y_ = event.y;
    return event;
  }

  void event() {
    const std::uint64_t kind = below(100);
    if (viewer_.prompt() && kind < 70) return answer();
    if (kind < 35) return press_key();
    if (kind < 40) return material();
    if (kind < 55) return handle(at_place(Kind::kMove));
    if (kind < 60) return drag();
    if (kind < 65) return drag_picked();
    if (kind < 75) return click();
    if (kind < 81) {
      WindowEvent wheel = at_place(Kind::kWheel);
      wheel.wheel = (one_in(2) ? -1 : 1) * (one_in(10) ? 40.0 : 1.0 + static_cast<double>(below(3)));
      return handle(wheel);
    }
    if (kind < 86) return resize();
    if (kind < 89) return handle({.kind = Kind::kFocus});
    if (kind < 91) return handle({.kind = Kind::kLeave});
    if (kind < 93) return handle({.kind = Kind::kText, .text = any_of(kTexts)});
    if (kind < 94) return one_in(5) ? handle({.kind = Kind::kQuit}) : material();
    handle(at_place(one_in(2) ? Kind::kPress : Kind::kRelease));  // one without the other, and of no button
  }

  void press_key() {
    const auto of = options_.dimension == 2 ? commands() : commands_3();
    WindowEvent key = key_event(one_in(12) ? std::string_view(any_of(kOtherKeys)) : of[below(of.size())].key);
    if (key.key.empty()) key = key_event("escape");
    if (one_in(10)) key.held = some_held();
    handle(key);
    ++result_.edits;
  }

  // The material under the mouse, or of what is picked, is given values: often those of another one, so that it acts
  // alike, or does no longer; and the view mode changes before its light is there.
  void material() {
    if (one_in(2)) {  // where the scene is seen
      handle(key_event("escape"));
      handle(key_event("f"));
      viewer_.viewer->update();
    }
    for (int k = 0; k < 5 && !viewer_.prompt(); ++k) {
      handle(at_place(Kind::kMove));
      handle(key_event("i"));
      handle({.kind = Kind::kText, .text = "i"});
    }
    if (!viewer_.prompt() || !viewer_.prompt()->keys.empty()) return;
    handle(key_event("ctrl+u"));
    handle({.kind = Kind::kText, .text = kTexts[below(6)]});
    handle(key_event("enter"));
    if (viewer_.prompt()) handle(key_event("escape"));
    if (one_in(2)) handle(key_event(std::to_string(below(one_in(2) ? 10 : 4))));
  }

  void click() {
    WindowEvent press = at_place(Kind::kPress);
    press.button = any_of(kButtons);
    handle(press);
    press.kind = Kind::kRelease;
    handle(press);
  }

  // With keys between, as a hand that does not let go; sometimes it never does.
  void drag() {
    WindowEvent press = at_place(Kind::kPress);
    press.button = any_of(kButtons);
    handle(press);
    for (std::uint64_t k = 1 + below(6); k > 0; --k) {
      handle(at_place(Kind::kMove));
      if (one_in(6)) press_key();
      if (one_in(3)) viewer_.viewer->update();
    }
    if (one_in(8)) return;
    WindowEvent release = at_place(Kind::kRelease);
    release.button = press.button;
    handle(release);
  }

  // What is under the mouse is picked, and dragged from there, along axes too; in the plane a click picks as well.
  void drag_picked() {
    if (one_in(3)) handle(key_event("f"));
    viewer_.viewer->update();
    WindowEvent press = at_place(Kind::kMove);
    press.button = MouseButton::kLeft;
    for (const Kind kind : {Kind::kMove, Kind::kPress, Kind::kRelease, Kind::kPress}) {
      press.kind = kind;
      if (kind == Kind::kPress && one_in(2)) press.held = some_held();
      handle(press);
    }
    for (std::uint64_t k = 1 + below(5); k > 0; --k) {
      if (one_in(3)) handle(key_event(any_of(std::array{"x", "y", "z"})));
      press.kind = Kind::kMove;
      press.x += static_cast<double>(below(61)) - 30;
      press.y += static_cast<double>(below(61)) - 30;
      handle(press);
      if (one_in(2)) viewer_.viewer->update();
    }
    if (one_in(6)) press_key();
    press.kind = Kind::kRelease;
    handle(press);
    const std::string moved = viewer_.shape();
    result_.shapes += moved != shape_ ? 1 : 0;
    shape_ = moved;
  }

  void resize() {
    ++result_.sizes;
    const auto side = [this](std::uint32_t most) {
      return static_cast<std::uint32_t>(one_in(4) ? 1 + below(3) : 1 + below(most));
    };
    const std::uint32_t width = side(options_.most_width), height = side(options_.most_height);
    window_.resize({width, height});
    handle({.kind = Kind::kResize});
  }

  // What is asked for is typed, and sometimes is right. No file is written beside those of the storm.
  void answer() {
    const Prompt asked = *viewer_.prompt();
    if (!asked.keys.empty())
      return handle(key_event(one_in(3) ? std::string("escape") : asked.keys[below(asked.keys.size())].first));
    handle(key_event("ctrl+u"));
    std::string text = any_of(kTexts);
    if (asked.question == "picture")
      text = (folder_ / any_of(std::array{"seen.png", "seen.svg", "seen.pdf", "seen"})).string();
    if (asked.question == "save as")
      text = (folder_ / any_of(std::array{"scene.json", "other.json", "scene.obj"})).string();
    if (asked.question != "picture" && asked.question != "save as" && one_in(3)) text = asked.text;
    if (!viewer_.prompt()) return;
    handle({.kind = Kind::kText, .text = text});  // dropped where it is that of the key which asked
    if (viewer_.prompt() && viewer_.prompt()->text != text && viewer_.prompt()->keys.empty())
      handle({.kind = Kind::kText, .text = text});
    if (viewer_.prompt() && viewer_.prompt()->text == text) handle(key_event(one_in(5) ? "escape" : "enter"));
    if (viewer_.prompt()) handle(key_event("escape"));
  }

  void look_at_file() {
    handle({.kind = Kind::kFocus});
    viewer_.viewer->update();
  }

  // Another program writes the file, which is gone for a while at times.
  void rewrite() {
    const char* const other = options_.dimension == 2 ? kOther2 : kOther3;
    if (one_in(4)) {
      std::filesystem::remove(file());
      look_at_file();
      if (one_in(2)) event();
    }
    ++result_.reads;
    write(one_in(6) ? "{" : is_changed_on_disk_ || one_in(2) ? first_ : other);
    is_changed_on_disk_ = !is_changed_on_disk_;
    look_at_file();
  }

  // (3)
  void rest() {
    for (int k = 0; k < 5 && viewer_.prompt(); ++k) viewer_.viewer->handle(key_event("escape"));
    for (const MouseButton button : kButtons)
      viewer_.viewer->handle({.kind = Kind::kRelease, .x = last_x_, .y = last_y_, .button = button});
    if (viewer_.viewer->pass_time(0)) viewer_.viewer->command("play");
    viewer_.viewer->settle(kPatience);
    std::string text;
    try {
      text = viewer_.written();
    } catch (const std::runtime_error&) {
      return;  // no file can hold it
    }
    if (viewer_.has_problem()) return;
    const std::filesystem::path copy = folder_ / "fresh" / "scene.json";
    std::filesystem::create_directories(copy.parent_path());
    std::ofstream(copy) << text;
    RecordingWindow window({64, 48});
    StormOptions undivided = options_;
    undivided.elements = 1;  // the file says how they are divided
    const StormViewer fresh = viewer_on(undivided, copy, window);
    fresh.viewer->settle(kPatience);
    ++result_.rests;
    const std::string here = viewer_.viewer->hashes(), there = fresh.viewer->hashes();
    if (here != there) fail("at rest the files are " + here + ", of a fresh viewer " + there);
  }

  static constexpr std::array kButtons{MouseButton::kLeft, MouseButton::kLeft, MouseButton::kLeft, MouseButton::kMiddle,
                                       MouseButton::kRight};
  const StormOptions options_;
  std::mt19937_64 random_;
  TemporaryFolder folder_;
  RecordingWindow window_;
  std::string first_, last_, shape_;
  StormViewer viewer_;
  StormResult result_;
  std::uint64_t rests_ = 0;
  double last_x_ = 0, last_y_ = 0;
  bool is_changed_on_disk_ = false;
};

}  // namespace

StormResult run_storm(const StormOptions& options) { return Storm(options).run(); }

}  // namespace hottel::viewer_storm
