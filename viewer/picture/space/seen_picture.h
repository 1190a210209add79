// What a camera sees, kept: to be drawn quickly, and asked what lies where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/picture/raster.h"
#include "viewer/picture/space/seen_parts.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

// The parts of what a camera sees (for_each_seen_part), with what they show.
//
//   (1) raster() is the picture of camera_view_3, toned; of light no level is off by more than one
//   (2) at() is what is drawn there: the part whose polygon holds the place; of two that share it the first
//   (3) it holds nothing of the scene, which may go
// COST: that of the map of the eye, and some microseconds a part. A megapixel takes some 40 ms, over all threads.
class SeenPicture3 {
 public:
  struct Part {
    PixelPolygon outline;                  // convex
    std::optional<std::uint32_t> element;  // nothing: a side without a row
    std::optional<Shade3> shade;           // nothing: its value all over
  };

  // Throws as for_each_seen_part.
  SeenPicture3(const SeenScene3& scene, const Camera3& camera);

  const std::vector<Part>& parts() const { return parts_; }
  // Nothing where the sky is seen. COST: linear in the parts.
  const Part* at(const Pixel& place) const;
  // tone: of light; null where the paint has a scale. Throws ContractViolation where it is not so.
  Raster raster(const ToneCurve* tone) const;

 private:
  template <std::size_t Channels>
  void draw_light(const PixelRows3& rows, const ToneCurve& tone, Raster& raster) const;
  void draw_values(const PixelRows3& rows, Raster& raster) const;

  ElementPaint3 paint_;
  std::uint32_t width_, height_;
  std::vector<Part> parts_;
};

}  // namespace hottel
