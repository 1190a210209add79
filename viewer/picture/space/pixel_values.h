// Values of pixels, and convex polygons added to them by their exact areas.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "viewer/picture/canvas.h"

namespace hottel {

// Rows of pixels from top to bottom; the channels of a pixel are beside each other. [unit: that of what is shown]
struct PixelValues3 {
  std::uint32_t width = 0, height = 0;
  std::size_t channels = 1;
  std::vector<double> values;

  std::span<const double> at(std::uint32_t x, std::uint32_t y) const {
    return std::span(values).subspan((std::size_t{y} * width + x) * channels, channels);
  }
};

// A convex polygon in a picture, its corners in order.
using PixelPolygon = std::vector<Pixel>;

// The place at the part t of the way between two.
Pixel place_between_3(const Pixel& a, const Pixel& b, double t);
// The mean of the corners. REQUIRES a corner.
Pixel middle_of_corners_3(std::span<const Pixel> polygon);

// Twice the area, negative where it goes around clockwise as y goes up.
double pixel_area_doubled_3(std::span<const Pixel> polygon);

// What a convex polygon covers of a pixel: how much, and the middle of that.
struct PixelCover3 {
  std::uint32_t x, y;
  double part;
  Pixel middle;
};

// Calls take(PixelCover3) for each pixel of a picture of that size that a convex polygon covers some of, by rows. What
// lies outside of the picture is left out. Areas are exact but for rounding. COST: some nanoseconds a pixel, and 100
// for each that the border passes.
template <class Take>
void for_each_covered_pixel(std::span<const Pixel> polygon, std::uint32_t width, std::uint32_t height,
                            const Take& take);

// The same for the rows [begin, end) of the picture alone.
struct PixelRows3 {
  std::uint32_t begin, end;
};
template <class Take>
void for_each_covered_pixel(std::span<const Pixel> polygon, std::uint32_t width, const PixelRows3& rows,
                            const Take& take);

// Adds `value` times the part of each pixel that a convex polygon covers.
void add_polygon(std::span<const Pixel> polygon, std::span<const double> value, PixelValues3& pixels);

// The part of a row of pixels within a convex polygon, from where to where it reaches, and from where to where it
// covers pixels wholly; for for_each_covered_pixel.
struct PixelStrip3 {
  PixelPolygon polygon;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double full_left = -left, full_right = left;

  PixelStrip3(std::span<const Pixel> whole, double top);
  // What of the pixel from x on is covered. REQUIRES that the row has some.
  PixelCover3 cover(std::uint32_t x, std::uint32_t y) const;
};

template <class Take>
void for_each_covered_pixel(std::span<const Pixel> polygon, std::uint32_t width, std::uint32_t height,
                            const Take& take) {
  for_each_covered_pixel(polygon, width, PixelRows3{0, height}, take);
}

template <class Take>
void for_each_covered_pixel(std::span<const Pixel> polygon, std::uint32_t width, const PixelRows3& rows,
                            const Take& take) {
  if (polygon.size() < 3) return;
  const auto [low, high] =
      std::minmax_element(polygon.begin(), polygon.end(), [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
  const double top = low->y, bottom = high->y;
  const auto clamped = [](double place, std::uint32_t least, std::uint32_t most) {
    return static_cast<std::uint32_t>(
        std::clamp(std::floor(place), static_cast<double>(least), static_cast<double>(most)));
  };
  for (std::uint32_t y = clamped(top, rows.begin, rows.end); y < rows.end && y < bottom; ++y) {
    const PixelStrip3 strip(polygon, y);
    if (strip.polygon.size() < 3) continue;
    for (std::uint32_t x = clamped(strip.left, 0, width); x < width && x < strip.right; ++x) {
      if (x >= strip.full_left && x + 1.0 <= strip.full_right)
        take(PixelCover3{x, y, 1, {x + 0.5, y + 0.5}});
      else
        take(strip.cover(x, y));
    }
  }
}

}  // namespace hottel
