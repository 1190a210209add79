#include "viewer/picture/space/pixel_painter.h"

#include <algorithm>

namespace hottel {

PixelPainter3::PixelPainter3(const ElementPaint3& paint, const Camera3& camera)
    : paint_(paint), shown_(paint.shown_channels() + 1), value_(paint.channels) {
  pixels_ = {camera.width, camera.height, shown_.size(), {}};
  pixels_.values.assign(std::size_t{camera.width} * camera.height * shown_.size(), 0);
  shown_.back() = 1;
}

void PixelPainter3::add(const SeenPart3& part) {
  if (part.shade != nullptr) return add_blended(part.outline, *part.shade);
  if (!part.element)
    std::copy(paint_.black.begin(), paint_.black.end(), shown_.begin());
  else if (!paint_.has_value(*part.element))
    std::copy(paint_.unknown.begin(), paint_.unknown.end(), shown_.begin());
  else
    paint_.show(paint_.value(*part.element), shown_);
  add_polygon(part.outline, shown_, pixels_);
}

void PixelPainter3::add_blended(std::span<const Pixel> outline, const Shade3& shade) {
  for_each_covered_pixel(outline, pixels_.width, pixels_.height, [&](const PixelCover3& cover) {
    shade.value(cover.middle, value_);
    add(cover, value_);
  });
}

void PixelPainter3::add(const PixelCover3& cover, std::span<const double> value) {
  paint_.show(value, shown_);
  double* pixel = pixels_.values.data() + (std::size_t{cover.y} * pixels_.width + cover.x) * pixels_.channels;
  for (std::size_t c = 0; c < shown_.size(); ++c) pixel[c] += cover.part * shown_[c];
}

PixelValues3 PixelPainter3::finished() const { return finished(0, 0, std::max(pixels_.width, pixels_.height)); }

PixelValues3 PixelPainter3::finished(std::uint32_t left, std::uint32_t top, std::uint32_t side) const {
  const std::size_t channels = paint_.shown_channels();
  PixelValues3 result{std::min(side, pixels_.width - left), std::min(side, pixels_.height - top), channels, {}};
  result.values.reserve(std::size_t{result.width} * result.height * channels);
  for (std::uint32_t y = top; y < top + result.height; ++y)
    for (std::uint32_t x = left; x < left + result.width; ++x) {
      const std::span<const double> pixel = pixels_.at(x, y);
      const double sky = std::max(0.0, 1 - pixel[channels]);
      for (std::size_t c = 0; c < channels; ++c) result.values.push_back(pixel[c] + sky * paint_.sky[c]);
    }
  return result;
}

}  // namespace hottel
