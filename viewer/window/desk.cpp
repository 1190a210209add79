#include "viewer/window/desk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

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

}  // namespace

void run_desk(Desk& desk, Window& window, double seconds) {
  Stopwatch watch;
  for (bool moves = false; !desk.wants_quit();) {
    const double most = moves ? std::min(seconds, kSecondsBetweenFrames) : seconds;
    for (std::size_t k = 0; k < kEventsPerFrame; ++k) {
      const std::optional<WindowEvent> event = window.next(k == 0 ? most : 0);
      if (!event) break;
      desk.handle(*event);
    }
    const double gone = watch.lap();
    moves = desk.pass_time(moves ? thousandths(gone) : Rational(0));
    desk.update();
  }
}

}  // namespace hottel
