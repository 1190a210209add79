// What is shown of parts of a picture, added up in pixels.
#pragma once

#include <span>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/picture/space/pixel_values.h"
#include "viewer/picture/space/seen_parts.h"

namespace hottel {

// Adds what is shown of parts to pixels, and tells what of each is left for the sky.
//
// REQUIRES that the paint outlives it, and parts that share no area.
class PixelPainter3 {
 public:
  PixelPainter3(const ElementPaint3& paint, const Camera3& camera);

  // A part of an element, or black.
  void add(const SeenPart3& part);
  // A convex polygon over which values run.
  void add_blended(std::span<const Pixel> outline, const Shade3& shade);
  // A part of a pixel with a value.
  void add(const PixelCover3& cover, std::span<const double> value);

  // With the sky where nothing is.
  PixelValues3 finished() const;
  // The same of a square of so many pixels a side from a place on, or what of it is in the picture.
  PixelValues3 finished(std::uint32_t left, std::uint32_t top, std::uint32_t side) const;

 private:
  const ElementPaint3& paint_;
  PixelValues3 pixels_;
  std::vector<double> shown_, value_;  // of one place; what is shown, and 1
};

}  // namespace hottel
