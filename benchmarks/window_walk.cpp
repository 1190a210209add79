// What the window of `hottel view` costs in space, at 1280 x 800 pixels: a room with two boxes and a lamp, and the
// Cornell box, their polygons divided.
//
// orbit: the eye goes five degrees around, and the frame is drawn anew. emission: an edit of the lamp, until its light
// is there and shown.
//
// Counters: elements; frames (a second) of the orbit; light, in ms: what the light of an edit takes, without the frame.
#include <string>

#include "benchmarks/clutter.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/stopwatch.h"
#include "viewer/window/recording_window.h"
#include "viewer/window/space/viewer.h"

namespace hottel::benchmarks {
namespace {

constexpr double kPatience = 600;  // seconds, for light

// A viewer with the light of the scene on it.
class Walk {
 public:
  Walk(const std::string& file, std::uint32_t n)
      : window_({1280, 800}),
        viewer_({file,
                 [file, n] {
                   Scene3 scene = read_scene_3(file);
                   divide_into(scene, n);
                   return scene;
                 }},
                window_, {}, 1) {
    viewer_.settle(kPatience);
  }
  Viewer3& viewer() { return viewer_; }
  double elements() const { return viewer_.state().version->model().table().count(); }

 private:
  RecordingWindow window_;
  Viewer3 viewer_;
};

void orbit(benchmark::State& state, const std::string& file, std::uint32_t n) {
  Walk walk(file, n);
  Stopwatch watch;
  double seconds = 0;
  for (auto _ : state) {
    watch.lap();
    walk.viewer().command("orbit left");
    walk.viewer().update();
    const double taken = watch.lap();
    seconds += taken;
    state.SetIterationTime(taken);
  }
  state.counters["elements"] = walk.elements();
  state.counters["frames"] = static_cast<double>(state.iterations()) / seconds;
  state.counters["light"] = 0;
}

void emission(benchmark::State& state, const std::string& file, std::uint32_t n) {
  Walk walk(file, n);
  Stopwatch watch;
  double light = 0;
  int k = 0;
  for (auto _ : state) {
    watch.lap();
    const std::string text = "lamp emission " + std::to_string(1 + ++k % 50);
    walk.viewer().do_own_step({"material", {"lamp", "emission"}, text, 1});
    walk.viewer().settle(kPatience);
    state.SetIterationTime(watch.lap());
    light += walk.viewer().state().version->seconds();
  }
  state.counters["elements"] = walk.elements();
  state.counters["frames"] = 0;
  state.counters["light"] = 1e3 * light / static_cast<double>(state.iterations());
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const char* scene : {"two_boxes", "cornell_box"})
    for (const std::uint32_t n : {1u, 2u, 4u, 6u}) {
      const std::string file = std::string("scenes/space/") + scene + ".json";
      const std::string name = std::string(scene) + "/divided:" + std::to_string(n);
      add_case(name + "/orbit", [file, n](benchmark::State& state) { orbit(state, file, n); });
      add_case(name + "/emission", [file, n](benchmark::State& state) { emission(state, file, n); });
    }
  return run(argc, argv);
}
