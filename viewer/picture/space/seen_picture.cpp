#include "viewer/picture/space/seen_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "kernel/support/parallel.h"
#include "viewer/picture/colour_map.h"

namespace hottel {
namespace {

constexpr std::uint32_t kRowsAtOnce = 16;  // so that their values stay in the cache
constexpr double kLeastArea = 1e-9;        // square pixels, of what can be pointed at

// False for a polygon without an area.
bool holds(const PixelPolygon& polygon, const Pixel& at) {
  const double area = pixel_area_doubled_3(polygon);
  if (std::fabs(area) < kLeastArea) return false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Pixel &a = polygon[k], &b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    const double side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    if (area > 0 ? side < 0 : side > 0) return false;
  }
  return true;
}

}  // namespace

SeenPicture3::SeenPicture3(const SeenScene3& scene, const Camera3& camera)
    : paint_(scene.paint), width_(camera.width), height_(camera.height) {
  for_each_seen_part(scene, camera, [this](const SeenPart3& part) {
    parts_.push_back({part.outline, part.element, part.shade ? std::optional(*part.shade) : std::nullopt});
  });
}

const SeenPicture3::Part* SeenPicture3::at(const Pixel& place) const {
  const auto found = std::ranges::find_if(parts_, [&](const Part& part) { return holds(part.outline, place); });
  return found == parts_.end() ? nullptr : &*found;
}

Raster SeenPicture3::raster(const ToneCurve* tone) const {
  Raster result(width_, height_);
  parallel_for((height_ + kRowsAtOnce - 1) / kRowsAtOnce, [&](std::size_t k) {
    const auto begin = static_cast<std::uint32_t>(k) * kRowsAtOnce;
    draw_rows({begin, std::min(begin + kRowsAtOnce, height_)}, tone, result);
  });
  return result;
}

// As PixelValues3 are filled, with what is covered in a last channel; then toned.
void SeenPicture3::draw_rows(const PixelRows3& rows, const ToneCurve* tone, Raster& raster) const {
  const std::size_t shown_channels = paint_.shown_channels(), channels = shown_channels + 1;
  std::vector<double> pixels(std::size_t{rows.end - rows.begin} * width_ * channels, 0);
  std::vector<double> shown(channels, 1), value(paint_.channels);
  const auto add = [&](const PixelCover3& cover) {
    double* pixel = pixels.data() + (std::size_t{cover.y - rows.begin} * width_ + cover.x) * channels;
    for (std::size_t c = 0; c < channels; ++c) pixel[c] += cover.part * shown[c];
  };
  for (const Part& part : parts_) {
    if (part.shade) {
      for_each_covered_pixel(part.outline, width_, rows, [&](const PixelCover3& cover) {
        part.shade->value(cover.middle, value);
        paint_.show(value, shown);
        add(cover);
      });
      continue;
    }
    if (part.element && paint_.has_value(*part.element))
      paint_.show(paint_.value(*part.element), shown);
    else
      std::ranges::copy(part.element ? paint_.unknown : paint_.black, shown.begin());
    for_each_covered_pixel(part.outline, width_, rows, add);
  }
  std::uint32_t* to = raster.pixels.data() + std::size_t{rows.begin} * width_;
  for (std::size_t k = 0; k < pixels.size(); k += channels) {
    const double sky = std::max(0.0, 1 - pixels[k + shown_channels]);
    for (std::size_t c = 0; c < shown_channels; ++c) pixels[k + c] += sky * paint_.sky[c];
    const std::span<const double> light(pixels.data() + k, shown_channels);
    const std::array<std::uint8_t, 3> level =
        tone ? tone->near_levels(light)
             : std::array<std::uint8_t, 3>{srgb_level(light[0]), srgb_level(light[1]), srgb_level(light[2])};
    *to++ =
        0xFF000000u | static_cast<std::uint32_t>(level[0]) << 16 | static_cast<std::uint32_t>(level[1]) << 8 | level[2];
  }
}

}  // namespace hottel
