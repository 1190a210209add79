// What stands for sdl_window.cpp in a build without SDL.
#include "kernel/support/failure.h"
#include "viewer/window/sdl_window.h"

namespace hottel {

std::unique_ptr<Window> open_window(const std::string&, FrameSize) {
  throw RequestError(
      "this hottel was built without a window (HOTTEL_WINDOW=OFF); --screenshot, --script and --record work");
}

}  // namespace hottel
