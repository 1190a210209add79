// How a scene in the plane is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/run_values.h"
#include "viewer/picture/plane/scene_picture.h"
#include "viewer/picture/plane/scene_sheet.h"
#include "viewer/picture/plane/stripes.h"

namespace hottel {

// Pixels beneath the drawing, over the floors: rows from the largest y down.
struct ScenePixels2 {
  Raster image{};
  std::array<double, 2> min{}, max{};  // the region they cover, in scene coordinates
  bool smooth = true;
  // Contours over them: a number for each, NaN where there is none, and the levels, which may be none.
  std::vector<double> values{}, levels{};
};

// Draws the plan. Without colouring each emitting face has a bright stripe on its side.
//
//   (1) one stripe for each straight part of a face with a value, on its own side of the edge (front = right of from ->
//       to), with the colour of the value; NaN is no value; a back without a material has no stripe, nor has what looks
//       into a solid or belongs to another surface. Where values are blended along faces (run_values_2) its
//       colour runs along it, within 1/128 of the scale that of the value
//   (2) each edge is drawn once, over the stripes: highlighted when it is a target
//   (3) nothing leaves the picture
//   (4) a legend iff there is colouring
//   (5) a key is left out where the footer has no room for it
//   (6) contours of the pixels beneath are over these and below the walls, which they do not cross
//   (draw_light_contours)
// Degenerate: a scene without surfaces is an empty sheet.
// Throws UsageError for a width out of range, ContractViolation for a target that is no surface. COST: O(n log n).
class ScenePicturePainter2 {
 public:
  // REQUIRES that prepared and picture outlive this.
  ScenePicturePainter2(const PreparedScene2& prepared, const ScenePicture2& picture);
  // The same on a sheet of this scene that is given.
  ScenePicturePainter2(const PreparedScene2& prepared, const ScenePicture2& picture, SceneSheet2 sheet);

  std::uint32_t width() const { return sheet_.width(); }
  std::uint32_t height() const { return sheet_.height(); }
  void draw(PictureCanvas& canvas) const;

 private:
  void draw_pixels(PictureCanvas& canvas) const;
  void draw_cell_contours(PictureCanvas& canvas) const;
  void draw_targets(PictureCanvas& canvas) const;
  void draw_footer(PictureCanvas& canvas) const;
  std::optional<Colour> colour(std::uint32_t run) const;
  void draw_below(PictureCanvas& canvas, std::span<const std::uint32_t> surfaces, const Stripes2& stripes) const;
  void draw_stripe(PictureCanvas& canvas, Mark mark, std::uint32_t run, const std::array<Pixel, 4>& stripe) const;

  const Scene2& scene_;
  const ScenePicture2& picture_;
  SceneSheet2 sheet_;
  FaceRuns2 runs_;
  std::vector<std::optional<RunValue2>> values_;  // of elements, per run
  std::vector<std::optional<Colour>> colours_;    // of the stripes, per run: of their middles
};

}  // namespace hottel
