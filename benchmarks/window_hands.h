// A viewer without a screen, and hands: what the benchmarks of the window share.
#pragma once

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/folder.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "viewer/window/plane/viewer.h"
#include "viewer/window/recording_window.h"

namespace hottel::benchmarks {

inline constexpr double kPatience = 60;  // seconds, for light

// A scene that is looked at: its file, and the grid of its light, which is that of the scene where it has one.
struct Room {
  std::string name;
  std::string file;
  SimulationRequest2 request;
};

// A scene in a folder, with light on 256 x 192 cells.
inline Room room_of(const std::string& name, const Scene2& scene, const Folder& folder) {
  const std::string edges = std::to_string(scene.edges.size()), file = folder.file(name + edges + ".json");
  std::ofstream(file) << write_scene_2(scene);
  return {name + "/edges:" + edges, file, {.grid = grid_over(scene, 256, 192)}};
}

// Rooms of furniture: `hottel generate room --n EDGES --seed 1`.
inline Scene2 furnished(std::uint64_t edges) {
  GeneratorRequest2 request;
  request.kind = "room";
  request.n = edges;
  request.seed = 1;
  return generate_2(request);
}

inline Room apartment() {
  const std::string file = "scenes/showcase/apartment.json";
  return {"apartment/edges:" + std::to_string(read_scene_2(file)->edges.size()), file, {}};
}

// A viewer of 1280 x 800 pixels that shows light, and what a mouse and a keyboard do to it.
class Hands {
 public:
  explicit Hands(const Room& room) : window_({1280, 800}), viewer_(room.file, window_, room.request, 1) {
    viewer_.command("look light");
    viewer_.settle(kPatience);
  }

  Viewer2& viewer() { return viewer_; }
  const Scene2& scene() const { return *viewer_.editor().scene(); }
  const LiveState2& state() const { return viewer_.views().state(); }

  // An event comes; it is taken by until_lit() or take_events().
  void push(WindowEvent event) {
    window_.push(std::move(event));
    since_push_.lap();
  }
  void mouse(WindowEvent::Kind kind, const Pixel& at, HeldKeys held = {}) {
    push({.kind = kind, .x = at.x, .y = at.y, .button = MouseButton::kLeft, .held = held});
  }

  // Takes the events that are there, and shows what has changed; waits so many seconds for the first.
  void take_events(double seconds = 0) {
    Stopwatch watch;
    for (auto event = window_.next(seconds); event; event = window_.next(0)) {
      watch.lap();
      viewer_.handle(*event);
      if (event->kind != WindowEvent::Kind::kWake) seconds_of_event_ = watch.lap();
    }
    viewer_.update();
  }

  // Runs until a frame shows light of the scene as it is, on the whole grid where that is asked for. Returns the
  // seconds since the last event came; nothing where the scene has no light.
  std::optional<double> until_lit(LiveDepth2 depth) {
    Stopwatch watch;
    for (double waited = 0; waited < kPatience; waited += watch.lap()) {
      take_events(0.05);
      const bool is_there = state().scene == viewer_.editor().scene();
      if (is_there && !state().light) return std::nullopt;
      if (is_there && (depth == LiveDepth2::kCoarse || state().depth == depth)) return Stopwatch(since_push_).lap();
    }
    throw RequestError("there is no light after a minute");
  }
  // What it took to take the last event.
  double seconds_of_event() const { return seconds_of_event_; }

 private:
  RecordingWindow window_;
  Viewer2 viewer_;
  Stopwatch since_push_;
  double seconds_of_event_ = 0;
};

}  // namespace hottel::benchmarks
