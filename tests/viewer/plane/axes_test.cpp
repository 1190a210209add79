// Coordinates along the frame of a picture, and the bar of scale.
#include "viewer/picture/plane/axes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "viewer/picture/recording_canvas.h"
#include "viewer/picture/scale_bar.h"

namespace hottel::axes_test {
namespace {

using Kind = RecordingCanvas::Kind;

RecordingCanvas axes(const Frame2& frame, const std::string& unit = "m") {
  RecordingCanvas canvas(frame.width(), frame.height());
  draw_axes_2(canvas, frame, 1, unit);
  return canvas;
}

constexpr SheetMargins2 kMargins{.left = 80, .right = 20, .top = 20, .bottom = 60};

TEST(Axes2, HaveTicksWhereTheirNumbersSay) {
  const Frame2 frame({2, -1}, {Rational(37, 10), Rational(1, 2)}, 80 + 680 + 20, 20 + 600 + 60, kMargins);
  EXPECT_EQ(frame.top_left(), (Pixel{80, 20}));
  EXPECT_EQ(frame.bottom_right(), (Pixel{760, 620}));
  std::size_t below = 0, left = 0;
  const RecordingCanvas canvas = axes(frame);
  for (const auto& call : canvas.calls()) {
    EXPECT_EQ(call.mark, Mark::kAxis);
    if (call.kind != Kind::kText || call.text == "m") continue;
    const double value = std::stod(call.text), middle_x = (call.points[0].x + call.points[1].x) / 2;
    if (call.points[0].y > 622) {
      EXPECT_NEAR(middle_x, 80 + (value - 2) * 400, 1e-6);
      ++below;
    } else {
      EXPECT_LE(call.points[1].x, 80);
      EXPECT_NEAR((call.points[0].y + call.points[1].y) / 2, 620 - (value + 1) * 400, 6);
      ++left;
    }
  }
  EXPECT_GE(below, 3u);
  EXPECT_GE(left, 3u);
  for (const auto& call : canvas.calls())
    if (call.kind == Kind::kStroke)
      for (const Pixel& p : call.points) {
        EXPECT_TRUE(74 <= p.x && p.x <= 760) << p.x;
        EXPECT_TRUE(20 <= p.y && p.y <= 626) << p.y;
      }
}

TEST(Axes2, SayTheUnitOfLengthOnce) {
  const Frame2 frame({0, 0}, {1, 1}, 700, 680, kMargins);
  int units = 0;
  const RecordingCanvas canvas = axes(frame, "ft");
  for (const auto& call : canvas.calls()) units += call.text == "ft";
  EXPECT_EQ(units, 1);
}

TEST(Axes2, WriteLongNumbersSmaller) {
  const Frame2 frame({0, Rational(123456789)}, {1, Rational(123456790)}, 700, 680, kMargins);
  std::size_t texts = 0;
  const RecordingCanvas canvas = axes(frame);
  for (const auto& call : canvas.calls())
    if (call.kind == Kind::kText && call.points[0].y < 622) {
      EXPECT_GE(call.points[0].x, -1e-9) << call.text;
      EXPECT_TRUE(call.text.starts_with("1234567") || call.text == "m") << call.text;
      ++texts;
    }
  EXPECT_GE(texts, 3u);
}

TEST(Axes2, AreALineAloneWhereDoublesDoNotTellPlacesApart) {
  const Rational far = Rational("100000000000000000000");
  const Frame2 frame({far, far}, {far + 1, far + 1}, 700, 680, kMargins);
  EXPECT_EQ(axes(frame).calls().size(), 4u);
}

TEST(ScaleBar2, IsARoundLengthThatFits) {
  for (const double pixels_per_length : {0.003, 1.0, 7.0, 1234.5}) {
    RecordingCanvas canvas(400, 100);
    draw_scale_bar(canvas, pixels_per_length, "mm", {{390, 50}, 100, 1});
    const auto& bar = canvas.calls().front();
    const double wide = bar.points[1].x - bar.points[0].x;
    EXPECT_TRUE(40 <= wide && wide <= 100) << wide;
    const std::string& text = canvas.calls().back().text;
    EXPECT_NEAR(std::stod(text) * pixels_per_length, wide, 1e-9 * wide);
    EXPECT_TRUE(text.ends_with(" mm"));
  }
}

}  // namespace
}  // namespace hottel::axes_test
