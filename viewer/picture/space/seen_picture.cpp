#include "viewer/picture/space/seen_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/colour_map.h"

namespace hottel {
namespace {

constexpr std::uint32_t kRowsAtOnce = 8;  // so that their values stay in the cache
constexpr double kLeastArea = 1e-9;       // square pixels, of what can be pointed at

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

std::uint32_t pixel_of(const std::array<std::uint8_t, 3>& level) {
  return 0xFF000000u | static_cast<std::uint32_t>(level[0]) << 16 | static_cast<std::uint32_t>(level[1]) << 8 |
         level[2];
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
  HOTTEL_REQUIRE((tone == nullptr) == paint_.scale.has_value());
  Raster result(width_, height_);
  parallel_for((height_ + kRowsAtOnce - 1) / kRowsAtOnce, [&](std::size_t k) {
    const auto begin = static_cast<std::uint32_t>(k) * kRowsAtOnce;
    const PixelRows3 rows{begin, std::min(begin + kRowsAtOnce, height_)};
    if (tone == nullptr)
      draw_values(rows, result);
    else if (paint_.channels == 1)
      draw_light<1>(rows, *tone, result);
    else
      draw_light<3>(rows, *tone, result);
  });
  return result;
}

// As PixelValues3 are filled, with what is covered in a last channel; then toned.
template <std::size_t Channels>
void SeenPicture3::draw_light(const PixelRows3& rows, const ToneCurve& tone, Raster& raster) const {
  using Levels = std::array<double, Channels>;
  std::vector<std::array<double, Channels + 1>> pixels(std::size_t{rows.end - rows.begin} * width_);
  const auto add = [&](const PixelCover3& cover, const Levels& light) {
    auto& pixel = pixels[std::size_t{cover.y - rows.begin} * width_ + cover.x];
    for (std::size_t c = 0; c < Channels; ++c) pixel[c] += cover.part * light[c];
    pixel[Channels] += cover.part;
  };
  for (const Part& part : parts_) {
    if (part.shade) {
      const Shade3::Quick<Channels> shade(*part.shade);
      for_each_covered_pixel(part.outline, width_, rows,
                             [&](const PixelCover3& cover) { add(cover, shade.at(cover.middle)); });
      continue;
    }
    Levels light{};
    if (part.element && paint_.has_value(*part.element))
      std::ranges::copy(paint_.value(*part.element), light.begin());
    else
      std::ranges::copy(part.element ? paint_.unknown : paint_.black, light.begin());
    for_each_covered_pixel(part.outline, width_, rows, [&](const PixelCover3& cover) { add(cover, light); });
  }
  std::uint32_t* to = raster.pixels.data() + std::size_t{rows.begin} * width_;
  for (auto& pixel : pixels) {
    const double sky = std::max(0.0, 1 - pixel[Channels]);
    for (std::size_t c = 0; c < Channels; ++c) pixel[c] += sky * paint_.sky[c];
    *to++ = pixel_of(tone.near_levels(std::span<const double>(pixel).first(Channels)));
  }
}

// The same of colours of a scale.
void SeenPicture3::draw_values(const PixelRows3& rows, Raster& raster) const {
  constexpr std::size_t kColours = 3;
  std::vector<std::array<double, kColours + 1>> pixels(std::size_t{rows.end - rows.begin} * width_);
  std::array<double, kColours> shown{};
  std::vector<double> value(paint_.channels);
  const auto add = [&](const PixelCover3& cover) {
    auto& pixel = pixels[std::size_t{cover.y - rows.begin} * width_ + cover.x];
    for (std::size_t c = 0; c < kColours; ++c) pixel[c] += cover.part * shown[c];
    pixel[kColours] += cover.part;
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
  for (const auto& pixel : pixels) {
    const double sky = std::max(0.0, 1 - pixel[kColours]);
    std::array<std::uint8_t, 3> level{};
    for (std::size_t c = 0; c < kColours; ++c) level[c] = srgb_level(pixel[c] + sky * paint_.sky[c]);
    *to++ = pixel_of(level);
  }
}

}  // namespace hottel
