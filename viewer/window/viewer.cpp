#include "viewer/window/viewer.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

constexpr std::size_t kEventsPerFrame = 200;
constexpr double kSecondsBetweenUpdates = 1;
constexpr double kSecondsBetweenFrames = 0.02;  // while lights move

Rational thousandths(double seconds) {
  Rational result(std::lround(seconds * 1000), 1000);
  result.canonicalize();
  return result;
}

// Of moves of the mouse one after the other the last one is handled.
void handle_events(Viewer& viewer, Window& window, double seconds) {
  WindowEvent move;
  bool has_move = false;
  for (std::size_t k = 0; k < kEventsPerFrame; ++k) {
    const std::optional<WindowEvent> event = window.next(k == 0 ? seconds : 0);
    if (!event) break;
    if (event->kind == WindowEvent::Kind::kMove) {
      move = *event;
      has_move = true;
      continue;
    }
    if (std::exchange(has_move, false)) viewer.handle(move);
    viewer.handle(*event);
  }
  if (has_move) viewer.handle(move);
}

}  // namespace

void run_viewer(Viewer& viewer, Window& window) {
  Stopwatch watch;
  for (bool moves = false; !viewer.wants_quit();) {
    const double most = moves ? kSecondsBetweenFrames : kSecondsBetweenUpdates;
    handle_events(viewer, window, most);
    const double gone = watch.lap();
    moves = viewer.pass_time(moves ? thousandths(gone) : Rational(0));
    viewer.update();
  }
}

}  // namespace hottel
