#include "viewer/picture/cairo_canvas.h"

#include <gmock/gmock.h>

#include "kernel/support/failure.h"

namespace hottel::cairo_canvas_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes.at(at + k));
  return value;
}

std::string drawn(PictureFormat format) {
  CairoCanvas canvas(format, 120, 80);
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {120, 80}, {1, 1, 1});
  canvas.stroke(Mark::kEdge, {10, 10}, {110, 70}, {0, 0, 0}, 3);
  canvas.text(Mark::kTitle, {60, 40}, "a \xc3\xa9 \xff\x80 \xe2\x82", {.size = 12, .anchor = TextAnchor::kCentre});
  Raster red_and_blue(2, 1);
  red_and_blue.pixels = {pixel_of({1, 0, 0}), pixel_of({0, 0, 1, 0.5})};
  canvas.image(Mark::kLight, {20, 20}, {60, 60}, red_and_blue, true);
  return canvas.finish();
}

TEST(CairoCanvas, WritesPngOfTheSizeAskedFor) {
  const std::string png = drawn(PictureFormat::kPng);
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(big_endian(png, 16), 120u);
  EXPECT_EQ(big_endian(png, 20), 80u);
}

TEST(CairoCanvas, WritesSvgOfTheSizeAskedFor) {
  const std::string svg = drawn(PictureFormat::kSvg);
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 120 80\""));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
}

TEST(CairoCanvas, SvgHoldsTextsAsText) {
  CairoCanvas canvas(PictureFormat::kSvg, 200, 100);
  canvas.text(Mark::kLabel, {10, 20}, "<a & b>", {.size = 16, .weight = TextWeight::kBold});
  canvas.stroke(Mark::kEdge, {0, 0}, {50, 50}, {1, 0, 0}, 2);
  canvas.begin_layer();
  canvas.text(Mark::kLabel, {190, 60}, "10⁻³", {.size = 12, .anchor = TextAnchor::kRight});
  canvas.end_layer(std::vector<std::vector<Pixel>>{{{0, 0}, {200, 0}, {200, 100}, {0, 100}}});
  const std::string svg = canvas.finish();
  EXPECT_THAT(svg, HasSubstr("font-weight=\"bold\""));
  EXPECT_THAT(svg, HasSubstr(">&lt;a &amp; b&gt;</text>"));
  EXPECT_THAT(svg, HasSubstr(">10⁻³</text>"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("glyph")));
  EXPECT_THAT(svg, testing::Not(HasSubstr("miterlimit:100000")));
  EXPECT_LT(svg.find("a &amp; b"), svg.find("rgb(100%,0%,0%)")) << "in their order";
}

TEST(CairoCanvas, WritesPdfOnAPageOfThreeQuartersOfAPointAPixel) {
  const std::string pdf = drawn(PictureFormat::kPdf);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 90 60 ]"));
  EXPECT_THAT(pdf, HasSubstr("%%EOF"));
}

TEST(CairoCanvas, IsReproducible) {
  for (const PictureFormat format : {PictureFormat::kPng, PictureFormat::kSvg, PictureFormat::kPdf})
    EXPECT_EQ(drawn(format), drawn(format));
}

// Two triangles side by side on white: each pixel of their common side is wholly covered by both together.
TEST(CairoCanvas, NeighboursFilledAtOnceHaveNoSeam) {
  const std::vector<Pixel> low{{0, 0}, {20, 7}, {0, 10}}, high{{20, 7}, {20, 17}, {0, 10}};
  const auto grey_pixels = [&](bool at_once) {
    Raster raster(20, 20, 0xFFFFFFFF);
    CairoCanvas canvas(raster);
    if (at_once) {
      canvas.fill_all(Mark::kLight, std::vector{low, high}, {0, 0, 0});
    } else {
      canvas.fill(Mark::kLight, low, {0, 0, 0});
      canvas.fill(Mark::kLight, high, {0, 0, 0});
    }
    canvas.finish();
    int count = 0;  // in the columns of the middle, where the outer borders are far
    for (std::uint32_t y = 8; y < 10; ++y)
      for (std::uint32_t x = 2; x < 10; ++x) count += (raster.pixels[y * 20 + x] & 255) != 0 ? 1 : 0;
    return count;
  };
  EXPECT_GT(grey_pixels(false), 0);
  EXPECT_EQ(grey_pixels(true), 0);
}

TEST(CairoCanvas, ALayerIsSeenWithinItsPolygons) {
  Raster raster(20, 10, 0xFFFFFFFF);
  CairoCanvas canvas(raster);
  canvas.begin_layer();
  canvas.fill_rectangle(Mark::kLight, {0, 0}, {20, 10}, {0, 0, 0});
  canvas.end_layer(std::vector<std::vector<Pixel>>{{{2, 2}, {6, 2}, {6, 6}, {2, 6}}, {{12, 2}, {18, 2}, {18, 8}}});
  canvas.fill_rectangle(Mark::kLight, {0, 9}, {20, 10}, {1, 0, 0});  // no longer within them
  canvas.finish();
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return raster.pixels[y * 20 + x]; };
  EXPECT_EQ(at(4, 4), 0xFF000000);
  EXPECT_EQ(at(17, 4), 0xFF000000);
  EXPECT_EQ(at(9, 4), 0xFFFFFFFF);
  EXPECT_EQ(at(4, 7), 0xFFFFFFFF);
  EXPECT_EQ(at(0, 9), 0xFFFF0000);
}

TEST(CairoCanvas, RefusesImpossibleSizes) {
  EXPECT_THROW(CairoCanvas(PictureFormat::kPng, 0, 10), UsageError);
  EXPECT_THROW(CairoCanvas(PictureFormat::kSvg, 10, kMaxPictureSide + 1), UsageError);
}

TEST(PictureFormat, IsChosenByTheEnding) {
  EXPECT_EQ(picture_format("a/b.png"), PictureFormat::kPng);
  EXPECT_EQ(picture_format("b.svg"), PictureFormat::kSvg);
  EXPECT_EQ(picture_format("b.pdf"), PictureFormat::kPdf);
  EXPECT_EQ(picture_format("b.jpg"), std::nullopt);
  EXPECT_EQ(picture_format("png"), std::nullopt);
}

}  // namespace
}  // namespace hottel::cairo_canvas_test
