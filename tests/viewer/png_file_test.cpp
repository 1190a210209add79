// PNG files, read again by another library; and the levels of a screen.
#include "viewer/picture/png_file.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "viewer/picture/colour_map.h"

namespace hottel::png_file_test {
namespace {

struct Source {
  const std::string* bytes;
  std::size_t place = 0;
};

cairo_status_t read(void* closure, unsigned char* data, unsigned int length) {
  auto* source = static_cast<Source*>(closure);
  if (source->place + length > source->bytes->size()) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, source->bytes->data() + source->place, length);
  source->place += length;
  return CAIRO_STATUS_SUCCESS;
}

void expect_read_back(std::uint32_t width, std::uint32_t height, std::size_t stride) {
  std::mt19937 random(width);
  std::vector<std::uint32_t> pixels(height * stride);
  for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = static_cast<std::uint32_t>(k % 7 == 0 ? random() : k);
  const std::string file = png_file(pixels.data(), width, height, stride);
  Source source{&file};
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &source);
  ASSERT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  ASSERT_EQ(cairo_image_surface_get_width(surface), static_cast<int>(width));
  ASSERT_EQ(cairo_image_surface_get_height(surface), static_cast<int>(height));
  std::size_t wrong = 0;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel,
                  cairo_image_surface_get_data(surface) +
                      static_cast<std::size_t>(cairo_image_surface_get_stride(surface)) * y + 4 * std::size_t{x},
                  4);
      if ((pixel & 0xffffff) != (pixels[y * stride + x] & 0xffffff)) ++wrong;
    }
  EXPECT_EQ(wrong, 0u) << width << " x " << height;
  EXPECT_EQ(source.place, file.size());
  cairo_surface_destroy(surface);
}

TEST(PngFile, HoldsEveryPixel) {
  expect_read_back(1, 1, 1);
  expect_read_back(3, 5, 8);
  expect_read_back(700, 1000, 700);  // several strips
  expect_read_back(16384, 70, 16384);
}

TEST(SrgbLevel, IsTheRoundedValue) {
  std::mt19937_64 random(1);
  std::vector<double> values{0, 1, 0x1p-13, 0x1p-14, 5e-324, 0.0031308, 0.5};
  for (int k = 0; k < 200'000; ++k) values.push_back(std::ldexp(static_cast<double>(random() >> 11), -53 - k % 16));
  for (int level = 1; level < 256; ++level)  // near where levels meet
    for (const double off : {-1e-9, -1e-15, 1e-15, 1e-9})
      values.push_back(std::clamp(linear_from_srgb((level - 0.5) / 255) * (1 + off), 0.0, 1.0));
  for (const double value : values) ASSERT_EQ(srgb_level(value), std::lround(255 * srgb_from_linear(value))) << value;
  EXPECT_EQ(srgb_level(-1), 0);
  EXPECT_EQ(srgb_level(2), 255);
  EXPECT_EQ(srgb_level(std::nan("")), 0);
}

}  // namespace
}  // namespace hottel::png_file_test
