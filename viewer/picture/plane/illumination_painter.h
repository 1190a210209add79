// How light in space is drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "solver/plane/light/light_values.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/corners.h"
#include "viewer/picture/plane/illumination_picture.h"
#include "viewer/picture/plane/light_pixels.h"
#include "viewer/picture/plane/stripes.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

// Draws the light of a grid, the solids of the arrangement over it, grey and hatched, and the edges on top,
// antialiased; emitting faces in the colour of their emission, less what looks into a solid.
//
//   (1) the picture is the region of the grid and nothing else: the top row is the largest y, each cell is the same
//       number of whole pixels, at least one
//   (2) before tone mapping the pixels are those of LightPixels2 with the scene as walls; without a value: grey
//
// Throws UsageError when the grid has more cells along a side than a picture may have pixels.
// COST: about 0.3 s for a picture of 1500 x 1200.
class IlluminationPainter2 {
 public:
  // REQUIRES that grid and prepared outlive this.
  IlluminationPainter2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                       const IlluminationPicture2& picture);

  std::uint32_t width() const { return pixels_.width(); }
  std::uint32_t height() const { return pixels_.height(); }
  // The curve, fitted to the values of this grid.
  const ToneCurve& tone() const { return tone_; }
  // REQUIRES a canvas of width() by height(). COST: the pixels are made in parallel, by rows of cells.
  void draw(PictureCanvas& canvas) const;

 private:
  void draw_walls(PictureCanvas& canvas) const;
  PixelImage light() const;

  const Scene2& scene_;
  const IlluminationGrid2& grid_;
  LightPixels2 pixels_;
  ToneCurve tone_;
  Frame2 frame_;
  Corners2 corners_;
  FaceRuns2 runs_;
  std::vector<std::vector<Pixel>> solids_;
  double unit_, wall_width_;
};

}  // namespace hottel
