// What a camera sees, kept: to be drawn quickly, and asked what lies where.
#pragma once

#include <array>
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
//   (4) once show() has given it another paint, it is, bit for bit, what would be made of that anew
// COST: that of the map of the eye, and some microseconds a part. A megapixel takes some 20 ms of a processor, over all
// threads; after show() a third of that, for which it keeps what each part covers: 16 bytes a row of a part, 32 for
// each pixel that its border passes.
class SeenPicture3 {
 public:
  struct Part {
    PixelPolygon outline;                  // convex
    std::optional<std::uint32_t> element;  // nothing: a side without a row
    std::optional<Shade3> shade;           // nothing: its value all over
    std::array<std::uint32_t, 2> corners;  // of the mesh, as in SeenPart3
  };

  // Throws as for_each_seen_part.
  SeenPicture3(const SeenScene3& scene, const Camera3& camera);

  // Shows another paint of the same elements. mesh: the one that it was made with, null where there was none. Returns
  // false, and nothing has changed, where that takes other parts: where values have other channels, or other elements
  // have none.
  bool show(const ElementPaint3& paint, const SmoothMesh3* mesh);

  const std::vector<Part>& parts() const { return parts_; }
  // Nothing where the sky is seen. COST: linear in the parts.
  const Part* at(const Pixel& place) const;
  // The picture before it is toned, its light as camera_view_3 has it.
  PixelValues3 values() const;
  // tone: of light; null where the paint has a scale. Throws ContractViolation where it is not so.
  Raster raster(const ToneCurve* tone) const;

 private:
  // What a part covers of a row of pixels: so many of its borders' pixels, as `covers` has them, and then all of those
  // from x on.
  struct Run {
    std::uint32_t part, at_border, x, whole;
  };
  // What parts cover of some rows, by parts, then by rows.
  struct Covers {
    std::vector<Run> runs;
    std::vector<PixelCover3> at_border;
    std::vector<std::uint32_t> rows;  // by run
  };

  std::size_t blocks() const;  // of rows
  PixelRows3 rows_of(std::size_t block) const;
  void keep_covers();
  // Calls paint(part, pixels) for parts that may cover some of the rows: pixels(take) calls take(PixelCover3).
  template <class Paint>
  void for_each_part(std::size_t block, const Paint& paint) const;
  template <std::size_t Channels>
  void draw_light(std::size_t block, const ToneCurve& tone, Raster& raster) const;
  void draw_values(std::size_t block, Raster& raster) const;

  ElementPaint3 paint_;
  std::uint32_t width_, height_;
  std::vector<Part> parts_;
  std::vector<Covers> covers_;  // by block of rows; none: before the first show()
};

}  // namespace hottel
