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

PixelValues3 PixelPainter3::finished() const {
  const std::size_t channels = paint_.shown_channels();
  PixelValues3 result{pixels_.width, pixels_.height, channels, {}};
  result.values.reserve(pixels_.values.size() / (channels + 1) * channels);
  for (std::size_t k = 0; k < pixels_.values.size(); k += channels + 1) {
    const double sky = std::max(0.0, 1 - pixels_.values[k + channels]);
    for (std::size_t c = 0; c < channels; ++c) result.values.push_back(pixels_.values[k + c] + sky * paint_.sky[c]);
  }
  return result;
}

}  // namespace hottel
