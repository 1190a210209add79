// What a frame of the window of `hottel view` costs, at 1280 x 800 pixels, for each view mode: everything is there, and
// is drawn anew.
//
// Counters, in ms: marks (what is drawn anew only where light, mode or view change: the time but for what lies over
// it), overlay (what is drawn in each frame: the selection, texts, and the hand-over to the window).
#include "benchmarks/window_hands.h"
#include "viewer/window/plane/view_mode.h"

namespace hottel::benchmarks {
namespace {

void frame(benchmark::State& state, const Room& room, ViewMode2 mode) {
  Hands hands(room);
  Viewer2& viewer = hands.viewer();
  hands.mouse(WindowEvent::Kind::kMove, {640, 400});
  hands.take_events();
  viewer.command(std::string("look ") + to_string(mode));
  viewer.settle(kPatience);
  Stopwatch watch;
  double whole = 0, overlay = 0;
  for (auto _ : state) {
    viewer.handle({.kind = WindowEvent::Kind::kFocus});
    watch.lap();
    viewer.update();
    overlay += watch.lap();
    viewer.handle({.kind = WindowEvent::Kind::kResize});
    watch.lap();
    viewer.update();
    const double seconds = watch.lap();
    whole += seconds;
    state.SetIterationTime(seconds);
  }
  const double runs = static_cast<double>(state.iterations());
  state.counters["overlay"] = 1e3 * overlay / runs;
  state.counters["marks"] = 1e3 * (whole - overlay) / runs;
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  using hottel::ViewMode2;
  const Folder folder("window-frames");
  std::vector<Room> rooms{apartment()};
  for (const std::uint64_t edges : {200, 2000}) rooms.push_back(room_of("room", furnished(edges), folder));
  for (const Room& room : rooms)
    for (const ViewMode2 mode : {ViewMode2::kLight, ViewMode2::kFloor, ViewMode2::kBands, ViewMode2::kVisibility,
                                 ViewMode2::kErrors, ViewMode2::kCheck, ViewMode2::kPlan})
      add_case(room.name + "/" + to_string(mode), [=](benchmark::State& state) { frame(state, room, mode); });
  return run(argc, argv);
}
