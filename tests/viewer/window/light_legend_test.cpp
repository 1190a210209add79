// What the brightness of light in a window means.
#include "viewer/window/light_legend.h"

#include <gtest/gtest.h>

#include <limits>

#include "viewer/picture/recording_canvas.h"

namespace hottel::light_legend_test {
namespace {

using Kind = RecordingCanvas::Kind;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

LightLegend legend_of(const std::vector<double>& values) {
  return {ToneCurve(Tone::kLog, 1, values, 1), values, 1, "radiosity [W/m²]"};
}

TEST(LightLegend, GoesFromTheDarkestThatIsLitToTheBrightest) {
  const ColourScale scale = legend_of({0, 0.5, kNaN, 100, 2}).scale();
  EXPECT_EQ(scale.lower, 0.5);
  EXPECT_EQ(scale.upper, 100);
  EXPECT_TRUE(scale.logarithmic);
  EXPECT_EQ(legend_of({1e-9, 100}).scale().lower, 0.1) << "a thousandth of the brightest";
  EXPECT_FALSE(legend_of({300, 400}).scale().logarithmic);
  EXPECT_EQ(legend_of({3, 3}).scale().lower, 0);
  EXPECT_TRUE(legend_of({0, 0}).is_dark());
  EXPECT_FALSE(legend_of({0, 1}).is_dark());
}

TEST(LightLegend, FitsIntoEachWindowAtEachScale) {
  for (const double unit : {1.0, 1.5, 2.0})
    for (const auto& [width, height] : {std::pair(640.0, 460.0), {1280.0, 800.0}}) {
      RecordingCanvas canvas(width, height);
      legend_of({0.5, 100}).draw(canvas, 20, height, unit);
      EXPECT_TRUE(canvas.wrote("radiosity [W/m²]"));
      EXPECT_TRUE(canvas.wrote("10"));
      for (const auto& call : canvas.calls())
        for (const Pixel& p : call.points) {
          EXPECT_GE(p.x, 0);
          EXPECT_LE(p.x, width);
          EXPECT_GE(p.y, 0);
          EXPECT_LE(p.y, height);
        }
    }
}

TEST(LightLegend, IsNotThereWhereItWouldHaveAThirdOfTheWindow) {
  RecordingCanvas canvas(640, 400);
  legend_of({0.5, 100}).draw(canvas, 20, 400, 2);
  EXPECT_TRUE(canvas.calls().empty());
}

TEST(LightLegend, MarksALightWhereTheScaleHasIt) {
  RecordingCanvas canvas(1280, 800), without(1280, 800);
  const LightLegend legend = legend_of({1, 10000});
  legend.draw(canvas, 100, 800, 1);
  legend.draw(without, {}, 800, 1);
  const auto strokes = canvas.calls(Mark::kLegend, Kind::kStroke);
  ASSERT_EQ(strokes.size(), without.calls(Mark::kLegend, Kind::kStroke).size() + 2);
  const auto bar = canvas.calls(Mark::kLegend, Kind::kImage).back().points;
  const double share = legend.scale().position(100);
  EXPECT_NEAR(strokes.back().points[0].x, bar[0].x + share * (bar[1].x - bar[0].x), 1e-9);
}

TEST(FirstTone, IsTheUsualOneUnlessLightIsNearlyEven) {
  std::vector<double> even(1000, 300), lamp(1000, 1);
  even[3] = 400;
  lamp[3] = 50;
  EXPECT_EQ(first_tone(even, 1, 2, Tone::kLog), (ToneChoice{Tone::kMax, 0.7}));
  even[5] = 1e-6;
  EXPECT_EQ(first_tone(even, 1, 2, Tone::kLog), (ToneChoice{Tone::kMax, 0.7})) << "one dark side makes no contrast";
  EXPECT_EQ(first_tone(lamp, 1, 2, Tone::kReinhard), (ToneChoice{Tone::kReinhard, 1}));
  EXPECT_EQ(first_tone(std::vector<double>(9, 0), 3, 2, Tone::kLog), ToneChoice());
  EXPECT_EQ(first_tone({}, 1, 2, Tone::kLog), ToneChoice());
}

}  // namespace
}  // namespace hottel::light_legend_test
