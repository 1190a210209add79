#include "viewer/picture/colour_map.h"

#include <gmock/gmock.h>

#include <cmath>

#include "viewer/picture/recording_canvas.h"

namespace hottel::colour_map_test {
namespace {

TEST(ColourScale, TellsZeroFromSmallWhereItHasZero) {
  const ColourScale plain{1e-4, 1, true}, with_zero{1e-4, 1, true, false, true};
  const auto same = [](const Colour& a, const Colour& b) { return pixel_of(a) == pixel_of(b); };
  EXPECT_TRUE(same(scale_colour(plain, 0), map_colour(0)));
  EXPECT_TRUE(same(scale_colour(with_zero, 1e-9), map_colour(0)));
  EXPECT_FALSE(same(scale_colour(with_zero, 0), map_colour(0)));
  EXPECT_GT(lightness(scale_colour(with_zero, 0)), lightness(scale_colour(with_zero, 1e-9)) + 0.3);
}

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

TEST(ColourMap, LightnessRisesEvenly) {
  const double dark = lightness(map_colour(0)), bright = lightness(map_colour(1));
  EXPECT_LT(dark + 0.4, bright);
  for (int k = 0; k <= 1000; ++k)
    EXPECT_NEAR(lightness(map_colour(k / 1000.0)), std::lerp(dark, bright, k / 1000.0), 1e-6);
}

TEST(ColourMap, StaysInsideTheScreenGamut) {
  for (int k = 0; k <= 1000; ++k) {
    const Colour c = map_colour(k / 1000.0);
    for (const double v : {c.r, c.g, c.b}) {
      EXPECT_GT(v, 0.0) << k;  // 0 or 1 would be the mark of cutting
      EXPECT_LT(v, 1.0) << k;
    }
  }
}

TEST(ColourMap, ClampsPositions) {
  EXPECT_EQ(map_colour(-3), map_colour(0));
  EXPECT_EQ(map_colour(7), map_colour(1));
}

TEST(Srgb, AgreesWithTheStandard) {
  EXPECT_NEAR(srgb_from_linear(0.18), 0.4613561295, 1e-9);
  EXPECT_NEAR(srgb_from_linear(0.001), 0.01292, 1e-15);
  EXPECT_NEAR(srgb_from_linear(1), 1, 1e-15);
  for (int k = 0; k <= 255; ++k) EXPECT_NEAR(srgb_from_linear(linear_from_srgb(k / 255.0)), k / 255.0, 1e-7);
}

TEST(Oklab, GreysHaveNoColour) {
  const Colour grey = colour_of({0.5, 0, 123});
  EXPECT_NEAR(grey.r, grey.g, 1e-6);
  EXPECT_NEAR(grey.g, grey.b, 1e-6);
  EXPECT_NEAR(lightness({1, 1, 1}), 1, 1e-6);
  EXPECT_NEAR(lightness({1, 0, 0}), 0.62796, 1e-4);  // Ottosson's value for red
}

TEST(ColourScale, PlacesValuesLinearlyOrByTheirLogarithm) {
  EXPECT_DOUBLE_EQ((ColourScale{2, 6}.position(3)), 0.25);
  EXPECT_DOUBLE_EQ((ColourScale{1e-4, 1, true}.position(1e-3)), 0.25);
  EXPECT_EQ((ColourScale{1e-4, 1, true}.position(0)), 0);
  EXPECT_EQ((ColourScale{0, 1}.position(-5)), 0);
  EXPECT_EQ((ColourScale{0, 1}.position(5)), 1);
  EXPECT_EQ((ColourScale{3, 3}.position(3)), 0);
  EXPECT_DOUBLE_EQ((ColourScale{-1.7e308, 1.7e308}.position(0)), 0.5);
}

TEST(ColourScale, TicksAreNiceNumbers) {
  EXPECT_THAT(tick_labels(ColourScale{0, 1}.ticks(6)), ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1"));
  EXPECT_THAT(tick_labels(ColourScale{-0.03, 0.11}.ticks(4)), ElementsAre("0", "0.05", "0.1"));
  EXPECT_THAT(ColourScale({1e-3, 1, true}).ticks(6), Pointwise(DoubleNear(1e-12), {1e-3, 1e-2, 1e-1, 1.0}));
  EXPECT_THAT(tick_labels(ColourScale{1e-3, 1, true}.ticks(6)), ElementsAre("0.001", "0.01", "0.1", "1"));
  EXPECT_LE((ColourScale{1e-300, 1, true}.ticks(6).size()), 6u);
  EXPECT_THAT(tick_labels(ColourScale{2, 8, true}.ticks(4)), ElementsAre("2", "4", "6", "8"));
  EXPECT_THAT((ColourScale{5, 5}.ticks(6)), ElementsAre(5.0));
}

TEST(ColourScale, TicksStayInRangeAndBelowTheLimit) {
  for (const double lower : {-1e6, -0.37, 0.0, 1e-9, 12.0})
    for (const double span : {1e-6, 0.7, 3.0, 999.0, 4e12})
      for (const int limit : {2, 3, 6, 11}) {
        const std::vector<double> ticks = ColourScale{lower, lower + span}.ticks(limit);
        EXPECT_LE(ticks.size(), static_cast<std::size_t>(limit));
        for (const double t : ticks) {
          EXPECT_GE(t, lower - 1e-6 * span);
          EXPECT_LE(t, lower + span + 1e-6 * span);
        }
      }
}

TEST(Legend, ShowsTitleLabelsAndAllColours) {
  RecordingCanvas canvas(500, 100);
  const double wide = draw_legend(canvas, {0, 1}, "fraction seen", {10, 10}, 300, 1);
  EXPECT_GE(wide, 300);
  EXPECT_LE(wide, 320);
  for (const char* text : {"fraction seen", "0", "0.4", "1"}) EXPECT_TRUE(canvas.wrote(text)) << text;
  const auto bar = canvas.calls(Mark::kLegend, RecordingCanvas::Kind::kImage);
  ASSERT_EQ(bar.size(), 1u);
  const auto colour = [](std::uint32_t pixel) {
    return Colour{(pixel >> 16 & 255) / 255.0, (pixel >> 8 & 255) / 255.0, (pixel & 255) / 255.0};
  };
  EXPECT_NEAR(lightness(colour(bar[0].image.pixels.front())), lightness(map_colour(0)), 0.01);
  EXPECT_NEAR(lightness(colour(bar[0].image.pixels.back())), lightness(map_colour(1)), 0.01);
}

TEST(Legend, ALongTitleStaysInTheCanvas) {
  RecordingCanvas canvas(320, 60);
  const std::string title = "radiosity, mean of r, g, b [W/m²]: 0.0166557 to 0.233878, values to 13.3508";
  draw_legend(canvas, {0, 1}, title, {10, 5}, 252, 0.6);
  for (const auto& call : canvas.calls(Mark::kLegend, RecordingCanvas::Kind::kText))
    for (const Pixel& p : call.points) EXPECT_LE(p.x, 320) << call.text;
}

}  // namespace
}  // namespace hottel::colour_map_test
