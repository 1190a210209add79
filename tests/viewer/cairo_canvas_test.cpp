#include "viewer/picture/cairo_canvas.h"

#include <gmock/gmock.h>

#include "kernel/support/failure.h"

namespace hottel {
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

TEST(CairoCanvas, IsReproducible) { EXPECT_EQ(drawn(PictureFormat::kPng), drawn(PictureFormat::kPng)); }

TEST(CairoCanvas, RefusesImpossibleSizes) {
  EXPECT_THROW(CairoCanvas(PictureFormat::kPng, 0, 10), UsageError);
  EXPECT_THROW(CairoCanvas(PictureFormat::kSvg, 10, kMaxPictureSide + 1), UsageError);
}

TEST(PictureFormat, IsChosenByTheEnding) {
  EXPECT_EQ(picture_format("a/b.png"), PictureFormat::kPng);
  EXPECT_EQ(picture_format("b.svg"), PictureFormat::kSvg);
  EXPECT_EQ(picture_format("b.jpg"), std::nullopt);
  EXPECT_EQ(picture_format("png"), std::nullopt);
}

}  // namespace
}  // namespace hottel
