// Coordinates along a frame, whichever way they run.
#include "viewer/picture/frame_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "viewer/picture/recording_canvas.h"

namespace hottel::frame_axes_test {
namespace {

TEST(FrameAxes, NumbersStandWhereTheyAreWhicheverWayTheyRun) {
  for (const bool falls : {false, true}) {
    RecordingCanvas canvas(700, 500);
    draw_frame_axes(canvas, {{100, 50}, {600, 400}, falls ? 5.0 : 0.0, falls ? 0.0 : 5.0, 0, 1, "x [m]", "z [m]"}, 1);
    for (const auto& call : canvas.calls()) {
      if (call.text.empty() || call.points[0].y < 402 || call.text == "x [m]") continue;
      const double middle = (call.points[0].x + call.points[1].x) / 2;
      EXPECT_NEAR(middle, falls ? 600 - 100 * std::stod(call.text) : 100 + 100 * std::stod(call.text), 1e-9);
    }
    EXPECT_TRUE(canvas.wrote("x [m]"));
    EXPECT_TRUE(canvas.wrote("z [m]"));
    const auto unit = std::ranges::find(canvas.calls(), "x [m]", &RecordingCanvas::Call::text);
    EXPECT_GT(unit->points[0].x, falls ? 600 : 500) << "after the last number";
  }
}

}  // namespace
}  // namespace hottel::frame_axes_test
