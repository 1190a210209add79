#include "viewer/picture/raster_drawing.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/png_file.h"

namespace hottel {
namespace {

std::uint32_t level(std::uint32_t pixel, int channel) { return pixel >> (8 * channel) & 0xFF; }

Raster noise(std::uint32_t width, std::uint32_t height, unsigned seed) {
  std::mt19937 random(seed);
  Raster raster(width, height);
  for (std::uint32_t& pixel : raster.pixels) pixel = 0xFF000000 | static_cast<std::uint32_t>(random());
  return raster;
}

// The pixel of the source at a place, by the words of the header.
std::uint32_t nearest(const Raster& source, double u, double v) {
  const auto index = [](double place, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(std::floor(place)), count - 1);
  };
  return source.pixels[std::size_t{index(v, source.height)} * source.width + index(u, source.width)];
}

double blended(const Raster& source, double u, double v, int channel) {
  const auto at = [&](double x, double y) {
    const auto column = static_cast<std::uint32_t>(std::clamp(x, 0.0, source.width - 1.0));
    const auto row = static_cast<std::uint32_t>(std::clamp(y, 0.0, source.height - 1.0));
    return static_cast<double>(level(source.pixels[std::size_t{row} * source.width + column], channel));
  };
  const double x = std::floor(u - 0.5), y = std::floor(v - 0.5), p = u - 0.5 - x, q = v - 0.5 - y;
  return (1 - q) * ((1 - p) * at(x, y) + p * at(x + 1, y)) + q * ((1 - p) * at(x, y + 1) + p * at(x + 1, y + 1));
}

// Calls f(pixel, u, v) for all pixels whose centres lie in the rectangle; (u, v) is the place of the centre in the
// source. All others must be as they were.
template <class F>
void for_drawn(const Raster& before, const Raster& after, Pixel a, Pixel b, const Raster& source, const F& f) {
  for (std::uint32_t y = 0; y < after.height; ++y)
    for (std::uint32_t x = 0; x < after.width; ++x) {
      const std::size_t k = std::size_t{y} * after.width + x;
      const double cx = x + 0.5, cy = y + 0.5;
      if (a.x <= cx && cx < b.x && a.y <= cy && cy < b.y) {
        f(after.pixels[k], (cx - a.x) / (b.x - a.x) * source.width, (cy - a.y) / (b.y - a.y) * source.height);
      } else {
        ASSERT_EQ(after.pixels[k], before.pixels[k]) << x << " " << y;
      }
    }
}

struct Rectangle {
  Pixel a, b;
};

const std::vector<Rectangle> kRectangles{
    {{0, 0}, {97, 71}},           {{-31, -20}, {300.25, 95}}, {{20.5, 10.5}, {60.5, 40.5}},
    {{20.25, 3}, {20.75, 60}},    {{-1e9, -1e9}, {1e9, 1e9}}, {{90, 60}, {500, 500}},
    {{-50, -50}, {0.5, 0.5}},     {{-50, -50}, {0.6, 0.6}},   {{200, 10}, {300, 20}},
    {{40, 40}, {40, 60}},         {{40, 40}, {10, 60}},       {{3.125, 2.5}, {11.125, 8.5}},
    {{-1e300, 5}, {1e300, 9.75}},
};

TEST(DrawPixels, DrawsTheNearestWhereCentresLieInTheRectangle) {
  const Raster before = noise(97, 71, 1);
  std::size_t drawn = 0;
  for (const auto& [width, height] : {std::pair{8u, 6u}, {1u, 1u}, {200u, 150u}, {97u, 71u}}) {
    const Raster source = noise(width, height, 2);
    for (const Rectangle& r : kRectangles) {
      Raster target = before;
      draw_pixels(target, r.a, r.b, source, false);
      for_drawn(before, target, r.a, r.b, source, [&](std::uint32_t pixel, double u, double v) {
        ++drawn;
        // Where a centre lies on a border of two pixels of the source, rounding decides.
        const double e = 1e-9 * source.width;
        const std::array<std::uint32_t, 4> allowed{
            nearest(source, std::max(u - e, 0.0), std::max(v - e, 0.0)), nearest(source, u + e, v + e),
            nearest(source, std::max(u - e, 0.0), v + e), nearest(source, u + e, std::max(v - e, 0.0))};
        ASSERT_THAT(allowed, testing::Contains(pixel)) << u << " " << v;
      });
    }
  }
  EXPECT_GT(drawn, 50000u);
}

TEST(DrawPixels, SmoothBlendsWithinTwoLevels) {
  const Raster before = noise(97, 71, 1);
  double worst = 0;
  for (const auto& [width, height] : {std::pair{8u, 6u}, {1u, 1u}, {200u, 150u}, {97u, 71u}}) {
    const Raster source = noise(width, height, 3);
    for (const Rectangle& r : kRectangles) {
      Raster target = before;
      draw_pixels(target, r.a, r.b, source, true);
      for_drawn(before, target, r.a, r.b, source, [&](std::uint32_t pixel, double u, double v) {
        EXPECT_EQ(level(pixel, 3), 255u);
        for (const int channel : {0, 1, 2})
          worst = std::max(worst, std::abs(level(pixel, channel) - blended(source, u, v, channel)));
      });
    }
  }
  EXPECT_LE(worst, 2);
  EXPECT_GT(worst, 0.5);  // levels are whole
}

TEST(DrawPixels, AnEvenColourStays) {
  for (const std::uint32_t colour : {0xFF000000u, 0xFFFFFFFFu, 0xFF010203u, 0xFFFE7F80u}) {
    Raster target(60, 40);
    draw_pixels(target, {-3.3, 0}, {60, 40}, Raster(7, 5, colour), true);
    EXPECT_EQ(target, Raster(60, 40, colour));
  }
}

TEST(DrawPixels, OfTheSameSizeIsACopy) {
  const Raster source = noise(60, 40, 4);
  for (const bool smooth : {false, true}) {
    Raster target(60, 40);
    draw_pixels(target, {0, 0}, {60, 40}, source, smooth);
    EXPECT_EQ(target, source);
  }
}

TEST(DrawPixels, NothingIsDrawnOfNothing) {
  Raster target = noise(9, 9, 5), none;
  const Raster before = target;
  for (const bool smooth : {false, true}) {
    draw_pixels(target, {0, 0}, {9, 9}, Raster(), smooth);
    draw_pixels(target, {0, 0}, {9, 9}, Raster(5, 0), smooth);
    draw_pixels(none, {0, 0}, {9, 9}, before, smooth);
  }
  EXPECT_EQ(target, before);
  EXPECT_EQ(none, Raster());
}

TEST(DrawPixels, DoesNotDependOnTheNumberOfThreads) {
  const Raster source = noise(64, 48, 6);
  for (const bool smooth : {false, true}) {
    Raster on_all(500, 400), on_one(500, 400);
    draw_pixels(on_all, {-10, 3}, {480, 450}, source, smooth);
    const ThreadLimit limit(1);
    draw_pixels(on_one, {-10, 3}, {480, 450}, source, smooth);
    EXPECT_EQ(on_all, on_one);
  }
}

TEST(DrawPixels, RefusesRastersOfTooFewPixels) {
  Raster whole(4, 4), broken(4, 4);
  broken.pixels.pop_back();
  EXPECT_THROW(draw_pixels(whole, {0, 0}, {4, 4}, broken, false), ContractViolation);
  EXPECT_THROW(draw_pixels(broken, {0, 0}, {4, 4}, whole, true), ContractViolation);
  EXPECT_THROW(png_file(broken), ContractViolation);
  EXPECT_THROW(png_file(Raster()), ContractViolation);
  EXPECT_THROW(CairoCanvas{broken}, ContractViolation);
}

TEST(Dim, TakesAFractionOfEveryColourAndNoOpacity) {
  Raster raster = noise(50, 40, 7);
  raster.pixels[0] = 0x80402010;
  for (const double fraction : {0.0, 0.25, 0.5, 1.0}) {
    Raster dimmed = raster;
    dim(dimmed, fraction);
    for (std::size_t k = 0; k < raster.pixels.size(); ++k) {
      EXPECT_EQ(level(dimmed.pixels[k], 3), level(raster.pixels[k], 3));
      for (const int channel : {0, 1, 2})
        EXPECT_EQ(level(dimmed.pixels[k], channel), std::floor((1 - fraction) * level(raster.pixels[k], channel)));
    }
  }
  EXPECT_THROW(dim(raster, -0.1), ContractViolation);
  EXPECT_THROW(dim(raster, 1.1), ContractViolation);
  EXPECT_THROW(dim(raster, std::nan("")), ContractViolation);
}

void draw_everything(PictureCanvas& canvas) {
  const std::vector<Pixel> star{{60, 5}, {75, 75}, {10, 30}, {110, 30}, {45, 75}};
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {100.5, 80}, {0.9, 0.95, 1});
  canvas.fill(Mark::kSolid, star, {0.2, 0.7, 0.3, 0.4});
  canvas.stroke(Mark::kEdge, {10, 10}, {130, 70}, {0, 0, 0}, 3);
  canvas.disc(Mark::kEye, {30, 60}, 9, {1, 0.5, 0, 0.75});
  Raster red_and_blue(2, 1);
  red_and_blue.pixels = {pixel_of({1, 0, 0}), pixel_of({0, 0, 1, 0.5})};
  canvas.image(Mark::kLight, {20, 20}, {60, 60}, red_and_blue, true);
  canvas.clip(star);
  canvas.circle(Mark::kEye, {70, 40}, 22.5, {1, 0, 0, 0.5}, 4);
  canvas.unclip();
  for (const TextAnchor anchor : {TextAnchor::kLeft, TextAnchor::kCentre, TextAnchor::kRight})
    for (const TextWeight weight : {TextWeight::kRegular, TextWeight::kBold})
      for (const double size : {12.0, 15.5, 12.0})
        canvas.text(Mark::kLabel, {60, 20 + size}, "a \xc3\xa9 W", {size, {0, 0, 0.4, 0.8}, anchor, weight});
}

TEST(CairoCanvas, OnABlackRasterIsThePng) {
  Raster raster(120, 80);
  {
    CairoCanvas canvas(raster);
    EXPECT_EQ(canvas.width(), 120);
    EXPECT_EQ(canvas.height(), 80);
    draw_everything(canvas);
    EXPECT_EQ(canvas.finish(), "");
  }
  CairoCanvas png(PictureFormat::kPng, 120, 80);
  draw_everything(png);
  EXPECT_EQ(png.finish(), png_file(raster));
  EXPECT_NE(raster, Raster(120, 80));
}

TEST(CairoCanvas, DrawsOntoWhatIsInTheRaster) {
  const Raster before = noise(40, 30, 8);
  Raster raster = before;
  { CairoCanvas(raster).fill_rectangle(Mark::kPaper, {10, 10}, {20, 20}, {1, 1, 1}); }
  for (std::uint32_t y = 0; y < 30; ++y)
    for (std::uint32_t x = 0; x < 40; ++x) {
      const bool inside = x >= 10 && x < 20 && y >= 10 && y < 20;
      EXPECT_EQ(raster.pixels[y * 40 + x], inside ? 0xFFFFFFFF : before.pixels[y * 40 + x]);
    }
}

TEST(CairoCanvas, RefusesRastersOfImpossibleSizes) {
  Raster none, wide(kMaxPictureSide + 1, 1);
  EXPECT_THROW(CairoCanvas{none}, UsageError);
  EXPECT_THROW(CairoCanvas{wide}, UsageError);
}

TEST(CairoCanvas, WritesLettersAlikeOnSeveralThreads) {
  const auto drawn = [] {
    Raster raster(120, 80);
    CairoCanvas canvas(raster);
    for (int k = 0; k < 20; ++k) draw_everything(canvas);
    canvas.finish();
    return raster;
  };
  const Raster expected = drawn();
  std::vector<Raster> rasters(4);
  std::vector<std::thread> threads;
  for (Raster& raster : rasters) threads.emplace_back([&raster, &drawn] { raster = drawn(); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(rasters, testing::Each(expected));
}

TEST(CairoCanvas, WidthsOfTextsFollowTheirStyle) {
  Raster raster(10, 10);
  const CairoCanvas canvas(raster);
  const double small = canvas.text_width("radiosity", {.size = 10}),
               large = canvas.text_width("radiosity", {.size = 20}),
               bold = canvas.text_width("radiosity", {.size = 10, .weight = TextWeight::kBold});
  EXPECT_NEAR(large, 2 * small, 1e-6 * large);
  EXPECT_GT(bold, small);
  EXPECT_EQ(canvas.text_width("radiosity", {.size = 10}), small);
}

}  // namespace
}  // namespace hottel
