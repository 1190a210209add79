#include "viewer/window/space/outlines.h"

#include <algorithm>
#include <cmath>

#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kInk = 0.45;  // of an outline
constexpr std::uint32_t kSky = 0, kBlack = 1;

std::uint32_t face_number(const SeenPicture3::Part& part, const ElementTable3& table) {
  if (!part.element) return kBlack;
  const Element& element = table.elements()[*part.element];
  return 2 + 2 * element.surface + (element.is_back ? 1 : 0);
}

// Calls row(y, first, end) for the pixels whose centres lie in a convex polygon.
template <class Row>
void for_each_row(const PixelPolygon& polygon, std::uint32_t width, std::uint32_t height, const Row& row) {
  if (polygon.empty()) return;
  const auto [low, high] = std::ranges::minmax(polygon, {}, &Pixel::y);
  const auto pixel = [](double v, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(most)));
  };
  for (std::uint32_t y = pixel(low.y, height); y < pixel(high.y, height); ++y) {
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Pixel &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      if ((a.y > y + 0.5) == (b.y > y + 0.5)) continue;
      const double x = std::lerp(a.x, b.x, (y + 0.5 - a.y) / (b.y - a.y));
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (left < right) row(y, pixel(left, width), pixel(right, width));
  }
}

std::uint32_t darkened(std::uint32_t pixel) {
  const std::uint32_t ink = pixel_of(palette::kInk);
  std::uint32_t result = 0xFF000000u;
  for (const int shift : {0, 8, 16}) {
    const double mixed = std::lerp(pixel >> shift & 255u, ink >> shift & 255u, kInk);
    result |= static_cast<std::uint32_t>(mixed + 0.5) << shift;
  }
  return result;
}

}  // namespace

void draw_outlines_3(Raster& raster, const std::vector<SeenPicture3::Part>& parts, const ElementTable3& table,
                     std::uint32_t width) {
  std::vector<std::uint32_t> faces(raster.pixels.size(), kSky);
  for (const SeenPicture3::Part& part : parts)
    for_each_row(part.outline, raster.width, raster.height,
                 [&](std::uint32_t y, std::uint32_t first, std::uint32_t end) {
                   std::fill_n(faces.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * raster.width + first),
                               end > first ? end - first : 0, face_number(part, table));
                 });
  for (std::uint32_t y = 0; y < raster.height; ++y)
    for (std::uint32_t x = 0; x < raster.width; ++x) {
      const std::size_t at = std::size_t{y} * raster.width + x;
      bool is_outline = false;
      for (std::uint32_t step = 1; step <= width; ++step)
        is_outline = is_outline || (x + step < raster.width && faces[at + step] != faces[at]) ||
                     (y + step < raster.height && faces[at + std::size_t{step} * raster.width] != faces[at]);
      if (is_outline) raster.pixels[at] = darkened(raster.pixels[at]);
    }
}

}  // namespace hottel
