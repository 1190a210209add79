#include "viewer/picture/space/pixel_raster.h"

#include <array>

#include "viewer/picture/colour_map.h"

namespace hottel {

Raster pixel_raster_3(const PixelValues3& pixels, const ToneCurve* tone, std::uint32_t rows_below) {
  Raster raster(pixels.width, pixels.height + rows_below);
  for (std::uint32_t y = 0; y < pixels.height; ++y)
    for (std::uint32_t x = 0; x < pixels.width; ++x) {
      const std::span<const double> shown = pixels.at(x, y);
      const std::array<std::uint8_t, 3> level =
          tone != nullptr
              ? tone->levels(shown)
              : std::array<std::uint8_t, 3>{srgb_level(shown[0]), srgb_level(shown[1]), srgb_level(shown[2])};
      raster.pixels[std::size_t{y} * raster.width + x] = pixel_of_levels(level);
    }
  return raster;
}

}  // namespace hottel
