#include "viewer/window/desk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

constexpr std::size_t kEventsPerFrame = 200;
constexpr double kSecondsBetweenFrames = 0.02;  // while lights move

Rational thousandths(double seconds) {
  Rational result(std::lround(seconds * 1000), 1000);
  result.canonicalize();
  return result;
}

// Of moves of the mouse one after the other the last one is handled.
void handle_events(Desk& desk, Window& window, double seconds) {
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
    if (std::exchange(has_move, false)) desk.handle(move);
    desk.handle(*event);
  }
  if (has_move) desk.handle(move);
}

}  // namespace

void run_desk(Desk& desk, Window& window, double seconds) {
  Stopwatch watch;
  for (bool moves = false; !desk.wants_quit();) {
    const double most = moves ? std::min(seconds, kSecondsBetweenFrames) : seconds;
    handle_events(desk, window, most);
    const double gone = watch.lap();
    moves = desk.pass_time(moves ? thousandths(gone) : Rational(0));
    desk.update();
  }
}

}  // namespace hottel
