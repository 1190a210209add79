#include "viewer/picture/raster.h"

#include <gmock/gmock.h>

#include <random>
#include <thread>
#include <vector>

#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/png_file.h"

namespace hottel::raster_test {
namespace {

Raster noise(std::uint32_t width, std::uint32_t height, unsigned seed) {
  std::mt19937 random(seed);
  Raster raster(width, height);
  for (std::uint32_t& pixel : raster.pixels) pixel = 0xFF000000 | static_cast<std::uint32_t>(random());
  return raster;
}

TEST(Raster, IsRefusedWithTooFewPixels) {
  Raster whole(4, 4), broken(4, 4);
  broken.pixels.pop_back();
  for (const bool smooth : {false, true})
    EXPECT_THROW(CairoCanvas(whole).image(Mark::kLight, {0, 0}, {4, 4}, broken, smooth), ContractViolation);
  EXPECT_THROW(png_file(broken), ContractViolation);
  EXPECT_THROW(png_file(Raster()), ContractViolation);
  EXPECT_THROW(CairoCanvas{broken}, ContractViolation);
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
}  // namespace hottel::raster_test
