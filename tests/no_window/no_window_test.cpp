#include <gmock/gmock.h>

#include "kernel/support/failure.h"
#include "viewer/window/sdl_window.h"

namespace hottel::no_window_test {
namespace {

TEST(NoWindow, SaysWhatWorksWithoutOne) {
  EXPECT_THAT(
      [] {
        open_window("title", {10, 10});
      },
      testing::ThrowsMessage<RequestError>(
          "this hottel was built without a window (HOTTEL_WINDOW=OFF); --screenshot, --script and --record work"));
}

}  // namespace
}  // namespace hottel::no_window_test
