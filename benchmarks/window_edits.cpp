// What a hand waits for that edits polygons in the window of `hottel view`: from an event to the frame that shows
// light.
//
// A viewer of 1280 x 800 pixels without a screen: a room with two boxes, and rooms of 16 and 48 boxes (102 and 294
// polygons). A box is taken and dragged along x in small steps, to and fro, and let go.
//
// The time of a case is the median from the event to the frame that shows coarse light of the scene as it is then.
// Counters, in ms, medians, `_p5` and `_p95` for what 5 and 95 of 100 stay under (on a busy machine `_p5` is what it
// would take on a quiet one):
//
//   event   taking the event          shape   until the frame that shows the new shape, in the light of before
//   light   as the time               full    from the release to the frame with the light of `solve`
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/folder.h"
#include "geometry/space/generate/generators.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "viewer/window/commands.h"
#include "viewer/window/recording_window.h"
#include "viewer/window/space/viewer.h"

namespace hottel::benchmarks {
namespace {

constexpr double kPatience = 600;
constexpr int kSteps = 42;  // which end elsewhere than they began

double share(std::vector<double> times, double fraction) {
  std::sort(times.begin(), times.end());
  const double place = std::ceil(fraction * static_cast<double>(times.size())) - 1;
  return times.empty() ? 0 : 1e3 * times[static_cast<std::size_t>(std::max(place, 0.0))];
}

// A hand that drags a piece of furniture.
class Drag {
 public:
  explicit Drag(const std::string& file)
      : window_({1280, 800}), viewer_({file, [file] { return read_scene_3(file); }}, window_, {}, 1) {
    viewer_.settle(kPatience);
    mouse_ = piece_of_furniture();
    send(WindowEvent::Kind::kPress, {.ctrl = true});
    send(WindowEvent::Kind::kRelease, {.ctrl = true});
  }

  void run() {
    send(WindowEvent::Kind::kPress, {.ctrl = true});
    send(WindowEvent::Kind::kMove);
    viewer_.handle(key_event("x"));
    for (int k = 0; k < kSteps; ++k) step(k % 8 < 4 ? 7 : -7);
    const auto before = viewer_.scene();
    Stopwatch watch;
    send(WindowEvent::Kind::kRelease);
    until([&] { return !viewer_.state().is_coarse && viewer_.state().is_lit(); });
    times_["full"].push_back(watch.lap());
  }
  std::map<std::string, std::vector<double>>& times() { return times_; }

 private:
  void send(WindowEvent::Kind kind, HeldKeys held = {}) {
    viewer_.handle({.kind = kind, .x = mouse_.x, .y = mouse_.y, .button = MouseButton::kLeft, .held = held});
  }

  // A pixel at which a group of several polygons is seen that is not the room.
  Pixel piece_of_furniture() {
    for (double y = 600; y > 40; y -= 8)
      for (double x = 600; x < 1280; x += 8) {
        const auto pick = viewer_.editor().pick(viewer_.camera().pointer({x, y}, {1280, 800}));
        if (!pick) continue;
        const std::uint32_t group = viewer_.scene()->surfaces[pick->face.surface].group;
        if (group_sizes(*viewer_.scene())[group] > 1 && viewer_.scene()->groups[group].name != "room") return {x, y};
      }
    throw RequestError("no furniture is seen");
  }

  void step(double pixels) {
    mouse_.x += pixels;
    const auto before = viewer_.scene();
    Stopwatch watch;
    send(WindowEvent::Kind::kMove);
    const double event = Stopwatch(watch).lap();
    if (viewer_.scene() == before) return;  // less than a decimal
    const auto is_there = [&] {
      const LiveVersion3* version = viewer_.state().version.get();
      return version != nullptr && version->scene().polygons == viewer_.scene()->polygons;
    };
    until(is_there);
    const double shape = Stopwatch(watch).lap();
    until([&] { return is_there() && viewer_.state().is_lit(); });
    times_["light"].push_back(Stopwatch(watch).lap());
    times_["event"].push_back(event);
    times_["shape"].push_back(shape);
  }

  template <class Condition>
  void until(const Condition& is_so) {
    Stopwatch watch;
    for (double waited = 0; waited < kPatience; waited += watch.lap()) {
      const bool has_shown = viewer_.update();
      if (is_so()) return;
      if (!has_shown) std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    throw RequestError("there is no light");
  }

  RecordingWindow window_;
  Viewer3 viewer_;
  Pixel mouse_{};
  std::map<std::string, std::vector<double>> times_;
};

void drag(benchmark::State& state, const std::string& file) {
  Drag hand(file);
  for (auto _ : state) {
    hand.run();
    state.SetIterationTime(share(hand.times()["light"], 0.5) / 1e3);
  }
  for (const char* name : {"event", "shape", "light", "full"}) {
    state.counters[name] = share(hand.times()[name], 0.5);
    state.counters[std::string(name) + "_p5"] = share(hand.times()[name], 0.05);
    state.counters[std::string(name) + "_p95"] = share(hand.times()[name], 0.95);
  }
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  const Folder folder("hottel-window-edits");
  add_case("two_boxes/drag", [](benchmark::State& state) { drag(state, "scenes/space/two_boxes.json"); });
  for (const std::uint64_t boxes : {16u, 48u}) {
    hottel::GeneratorRequest3 request;
    request.kind = "room-boxes";
    request.n = boxes;
    request.seed = 1;
    const std::string file = folder.file("room" + std::to_string(boxes) + ".json");
    std::ofstream(file) << hottel::write_scene_3(hottel::generate_3(request));
    add_case("room-boxes/boxes:" + std::to_string(boxes) + "/drag",
             [file](benchmark::State& state) { drag(state, file); });
  }
  return run(argc, argv);
}
