// Pixels as a screen takes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hottel {

// Rows of pixels from top to bottom, one after the other: 0xAARRGGBB, sRGB, the colours multiplied by the opacity A.
struct Raster {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  // width * height

  Raster() = default;
  Raster(std::uint32_t w, std::uint32_t h, std::uint32_t pixel = 0xFF000000)
      : width(w), height(h), pixels(std::size_t{w} * h, pixel) {}
  friend bool operator==(const Raster&, const Raster&) = default;
};

}  // namespace hottel
