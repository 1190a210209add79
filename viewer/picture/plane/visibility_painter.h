// How what points and edges see is drawn.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/face.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/scene_sheet.h"
#include "viewer/picture/plane/visibility_picture.h"

namespace hottel {

// The size of the drawing on a sheet, and the drawing on a canvas of that size.
//
//   (1) the light lies over the floors and beneath the walls, translucent and warm
//   (2) the eye and all critical points are shown, outside the scene too; what reaches out of the picture is cut off
// Throws UsageError for a width out of range. REQUIRES that the drawing outlives this.
class VisibilityPainter2 {
 public:
  VisibilityPainter2(const PreparedScene2& prepared, const VisibilityDrawing2& drawing);
  // The same on a sheet of this scene that is given.
  VisibilityPainter2(const VisibilityDrawing2& drawing, SceneSheet2 sheet);
  std::uint32_t width() const { return sheet_.width(); }
  std::uint32_t height() const { return sheet_.height(); }
  void draw(PictureCanvas& canvas) const;

 private:
  const VisibilityDrawing2& drawing_;
  SceneSheet2 sheet_;
};

// The same of two edges.
//
//   (1) each of the two edges is drawn in a colour of its own, with its label on the side that is meant
//   (2) one small circle for each critical point
// REQUIRES faces of the scene; throws ContractViolation otherwise. The drawing outlives this.
class PairPainter2 {
 public:
  PairPainter2(const PreparedScene2& prepared, const PairDrawing2& drawing);
  // The same on a sheet of this scene that is given.
  PairPainter2(const PairDrawing2& drawing, SceneSheet2 sheet);
  std::uint32_t width() const { return sheet_.width(); }
  std::uint32_t height() const { return sheet_.height(); }
  void draw(PictureCanvas& canvas) const;

 private:
  void draw_edge(PictureCanvas& canvas, const Face& face, const std::string& label, const Colour& colour) const;

  const PairDrawing2& drawing_;
  SceneSheet2 sheet_;
};

}  // namespace hottel
