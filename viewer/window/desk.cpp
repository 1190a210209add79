#include "viewer/window/desk.h"

#include <cstddef>
#include <optional>

namespace hottel {
namespace {

constexpr std::size_t kEventsPerFrame = 200;

}  // namespace

void run_desk(Desk& desk, Window& window, double seconds) {
  while (!desk.wants_quit()) {
    for (std::size_t k = 0; k < kEventsPerFrame; ++k) {
      const std::optional<WindowEvent> event = window.next(k == 0 ? seconds : 0);
      if (!event) break;
      desk.handle(*event);
    }
    desk.update();
  }
}

}  // namespace hottel
