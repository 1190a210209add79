// How light in space is drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/light/light_values.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/contours.h"
#include "viewer/picture/plane/corners.h"
#include "viewer/picture/plane/frame.h"
#include "viewer/picture/plane/illumination_picture.h"
#include "viewer/picture/plane/light_pixels.h"
#include "viewer/picture/plane/stripes.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

// What lies over light: the solids of the arrangement, grey and hatched, and the edges on top, antialiased; emitting
// faces in the colour of their emission, less what looks into a solid. Its lines are `unit` times as wide as in a
// picture of 1600 pixels.
class LitPlan2 {
 public:
  // REQUIRES that prepared outlives this.
  LitPlan2(const PreparedScene2& prepared, const Frame2& frame, double unit);
  void draw(PictureCanvas& canvas, const ToneCurve& tone) const;
  // Where edges lie in the picture.
  const Corners2& edges() const { return corners_; }

 private:
  void draw_emitters(PictureCanvas& canvas, const ToneCurve& tone) const;

  const Scene2& scene_;
  Corners2 corners_;
  FaceRuns2 runs_;
  std::vector<std::vector<Pixel>> solids_;
  double unit_, wall_width_;
};

// Returns the pixels of light after the tone curve, the largest y on top; without a value: grey. The grid is that of
// the pixels. Throws Interrupted when asked to stop. COST: about 20 ns a pixel on one core, on all threads by rows of
// cells.
Raster toned_pixels_2(const IlluminationGrid2& grid, const LightPixels2& pixels, const ToneCurve& tone);

// Draws the light of a grid, and over it the plan (LitPlan2).
//
//   (1) the picture is the region of the grid and nothing else, but for margins around it where axes are asked for: the
//       top row is the largest y, each cell is the same number of whole pixels, at least one
//   (2) before tone mapping the pixels are those of LightPixels2 with the scene as walls; without a value: grey
//   (3) contours run where the pixels of (2), the mean of all channels, have their level, once what is finer than cells
//       is blended (smoothed_field); they cross neither walls nor each other, and each has one label at most
//
// Throws UsageError when the grid has more cells along a side than a picture may have pixels.
// COST: about 0.3 s for a picture of 1500 x 1200.
class IlluminationPainter2 {
 public:
  // REQUIRES that grid and prepared outlive this.
  IlluminationPainter2(const PreparedScene2& prepared, const IlluminationGrid2& grid,
                       const IlluminationPicture2& picture);

  std::uint32_t width() const { return static_cast<std::uint32_t>(frame_.width()); }
  std::uint32_t height() const { return static_cast<std::uint32_t>(frame_.height()); }
  // The curve, fitted to the values of this grid.
  const ToneCurve& tone() const { return tone_; }
  // REQUIRES a canvas of width() by height(). COST: the pixels are made in parallel, by rows of cells.
  void draw(PictureCanvas& canvas) const;

 private:
  PixelField field() const;
  void draw_margins(PictureCanvas& canvas) const;

  const IlluminationGrid2& grid_;
  std::vector<double> contours_;
  bool has_axes_;
  std::string length_unit_;
  LightPixels2 pixels_;
  double unit_;
  Frame2 frame_;
  ToneCurve tone_;
  LitPlan2 plan_;
};

}  // namespace hottel
