// Whatever a hand does in a window: its light is that of a new window on the saved scene, and of a fresh process, byte
// for byte.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "io/files/text_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/cli/program.h"
#include "tests/sanitizers.h"
#include "tests/solver/plane/edited_scenes.h"
#include "viewer/window/commands.h"
#include "viewer/window/plane/viewer.h"
#include "viewer/window/plane/viewer_script.h"
#include "viewer/window/recording_window.h"

namespace hottel::testing_cli::edited_viewer_test {
namespace {

constexpr std::uint32_t kCells = 6;
constexpr double kPatience = 300;
constexpr int kEdits = kHasAddressSanitizer ? 60 : 1000;
constexpr int kPerProcess = 5;  // edits, of which one is given to fresh processes: these take most of the time

// A hand that does things at random, by the events that a window gives.
class RandomHand {
 public:
  RandomHand(Viewer2& viewer, std::uint64_t seed) : viewer_(viewer), random_(seed) {}

  // Does one thing, and what leads to it. Returns what it was.
  std::string act() {
    if (scene().surfaces.size() < 3) return key("ctrl+z");
    if (scene().surfaces.size() > 36) {
      click(middle(), {});
      return key("delete");
    }
    switch (below(16)) {
      case 0:
        drag(vertex(), vertex(), {});
        return "a vertex onto a vertex";
      case 1:
        drag(vertex(), on_edge(), {});
        return "a vertex onto an edge";
      case 2:
        drag(vertex(), anywhere(), {.alt = below(2) == 0});
        return "a vertex anywhere";
      case 3:
        drag(middle(), anywhere(), {.alt = below(2) == 0});
        return "an edge through walls";
      case 4:
        drag(on_edge(), vertex(), {});
        return "an edge onto a vertex";
      case 5:
        drag(middle(), anywhere(), {.ctrl = true});
        return "a group";
      case 6:
        click(below(2) == 0 ? vertex() : middle(), {});
        return key(std::string(below(2) == 0 ? "shift+" : "") + pick({"left", "right", "up", "down"}));
      case 7:
        click(middle(), {.ctrl = below(2) == 0});
        return key(pick({"r", "shift+r", "ctrl+r"}));
      case 8:
        click(middle(), {.ctrl = below(2) == 0});
        return key(pick({"d", "v", "delete"}));
      case 9:
      case 10:
        move(middle());
        return key(std::string(below(3) == 0 ? "shift+" : "") + pick({"[", "]", ";", "'", "k"}));
      case 11:
        click(below(2) == 0 ? vertex() : middle(), {});
        return type("enter", number() + " " + number());
      case 12:
        move(middle());
        return type("i", "reflectivity 0." + std::to_string(below(10)) + "; emission " + std::to_string(below(4)));
      case 13:
        return draw();
      case 14:
        return key("ctrl+y");
      default:
        for (std::size_t k = below(3); k > 0; --k) key("ctrl+z");
        return key("ctrl+z");
    }
  }

  std::string key(const std::string& text) {
    viewer_.handle(key_event(text));
    return text;
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

 private:
  const Scene2& scene() const { return *viewer_.editor().scene(); }
  const char* pick(const std::vector<const char*>& words) { return words[below(words.size())]; }
  std::string number() { return std::to_string(below(17)) + pick({"/2", "/3", "", "/7"}); }

  const Edge2& edge() { return scene().edges[below(scene().edges.size())]; }
  Pixel between(const Edge2& e, double t) {
    return viewer_.pixel_of(
        {std::lerp(to_double(e.from.x), to_double(e.to.x), t), std::lerp(to_double(e.from.y), to_double(e.to.y), t)});
  }
  Pixel vertex() { return between(edge(), static_cast<double>(below(2))); }
  Pixel middle() { return between(edge(), 0.5); }
  Pixel on_edge() { return between(edge(), static_cast<double>(1 + below(9)) / 10); }
  Pixel anywhere() {
    return viewer_.pixel_of({static_cast<double>(below(81)) / 10, static_cast<double>(below(81)) / 10});
  }

  void send(WindowEvent::Kind kind, const Pixel& at, const HeldKeys& held) {
    viewer_.handle({.kind = kind, .x = at.x, .y = at.y, .button = MouseButton::kLeft, .held = held});
  }
  void move(const Pixel& at) { send(WindowEvent::Kind::kMove, at, {}); }
  void click(const Pixel& at, const HeldKeys& held) {
    send(WindowEvent::Kind::kMove, at, held);
    send(WindowEvent::Kind::kPress, at, held);
    send(WindowEvent::Kind::kRelease, at, held);
  }
  void drag(const Pixel& from, const Pixel& to, const HeldKeys& held) {
    send(WindowEvent::Kind::kMove, from, held);
    send(WindowEvent::Kind::kPress, from, held);
    for (int k = 1; k <= 4; ++k)
      send(WindowEvent::Kind::kMove, {std::lerp(from.x, to.x, k / 4.0), std::lerp(from.y, to.y, k / 4.0)}, held);
    if (below(4) == 0) viewer_.update();  // a frame in the middle of it
    send(WindowEvent::Kind::kRelease, to, held);
  }
  std::string type(const std::string& opens, const std::string& text) {
    key(opens);
    key("ctrl+u");
    viewer_.handle({.kind = WindowEvent::Kind::kText, .text = text});
    key("enter");
    if (viewer_.prompt()) key("escape");
    return opens + " " + text;
  }
  std::string draw() {
    const std::string tool = pick({"e", "p", "l"});
    move(anywhere());
    key(tool);
    if (tool == "l") return tool;
    for (int k = 0; k < 3; ++k) click(below(2) == 0 ? anywhere() : on_edge(), {});
    if (tool == "p") key("enter");
    key("escape");
    return tool;
  }

  Viewer2& viewer_;
  std::mt19937_64 random_;
};

// What the program says after "hottel: FILE:LINE: ", without the lines of files, which saving counts anew.
std::string without_place(const std::string& message, const std::string& file) {
  std::string text = message.substr(0, message.find('\n'));
  if (const auto at = text.find(file); at != std::string::npos) text.erase(0, at + file.size());
  const auto begin = text.find(": ");
  return begin == std::string::npos ? text : text.substr(begin + 2);
}

TEST(EditedViewer, IsThatOfANewViewerAndAFreshProcessAfterEveryEdit) {
  Workplace place;
  Scene2 room = room_to_edit();
  room.grids = {grid_over(room, kCells, kCells)};
  const std::string file = place.path("edited.json").string(), fresh = place.path("fresh.json").string();
  place.write("edited.json", write_scene_2(room));
  RecordingWindow window({320, 320});
  Viewer2 viewer(file, window, {}, 1);
  RandomHand hand(viewer, 20261122);
  int lit = 0, dark = 0, none = 0;
  for (int k = 0; k < kEdits; ++k) {
    if (k % 50 == 0) hand.key("f");
    // Out of trouble, half of the time.
    const bool is_dark = !viewer.views().state().problem.empty();
    const std::string what = is_dark && hand.below(2) == 0 ? hand.key("ctrl+z") : hand.act();
    viewer.settle(kPatience);
    const LiveState2& state = viewer.views().state();
    ASSERT_EQ(state.scene, viewer.editor().scene()) << k << " " << what;
    ASSERT_FALSE(viewer.prompt()) << k << " " << what;
    const std::string hashes = result_hashes(state);
    try {
      validate(*state.scene);
    } catch (const InputError&) {
      ASSERT_EQ(hashes, "factors.csv - radiosity.csv - illumination.npy -");
      ASSERT_NE(state.problem, "");
      ++none;
      continue;
    }
    place.write("fresh.json", write_scene_2(*state.scene));
    const bool is_lit = state.problem.empty();
    RecordingWindow other_window({320, 320});
    Viewer2 other(fresh, other_window, {}, 1);
    other.settle(kPatience);
    ASSERT_EQ(hashes, result_hashes(other.views().state())) << k << " " << what;
    ASSERT_EQ(without_place(state.problem, file), without_place(other.views().state().problem, fresh))
        << k << " " << what;
    is_lit ? ++lit : ++dark;
    if (k % kPerProcess != 0) continue;
    const Outcome outcome = place.run("rm -rf out; hottel solve fresh.json --quiet --no-picture -o out");
    ASSERT_EQ(outcome.code == 0, is_lit) << k << " " << what << outcome.err;
    if (!is_lit) {
      ASSERT_EQ(hashes, "factors.csv - radiosity.csv - illumination.npy -") << k << " " << what << outcome.err;
      ASSERT_EQ(without_place(outcome.err, "fresh.json"), without_place(state.problem, file)) << k << " " << what;
      continue;
    }
    const Outcome factors = place.run("hottel factors fresh.json --quiet");
    ASSERT_EQ(factors.code, 0) << factors.err;
    ASSERT_EQ(hashes, "factors.csv " + sha256(factors.out) + " radiosity.csv " +
                          sha256(place.read("out/radiosity.csv")) + " illumination.npy " +
                          sha256(place.read("out/illumination.npy")))
        << k << " " << what;
  }
  EXPECT_GT(lit, kEdits / 3);
  EXPECT_GT(dark + none, kEdits / 100) << lit;
}

}  // namespace
}  // namespace hottel::testing_cli::edited_viewer_test
