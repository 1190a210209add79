// What a point sees, and what two edges see of each other, as drawings.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/results/plane/visibility_report.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/scene_sheet.h"

namespace hottel {

// What a point sees, to be drawn. All points in scene coordinates, finite; they are rounded, being for the eye only.
struct VisibilityDrawing2 {
  SheetText2 sheet{};
  std::array<double, 2> eye{};
  std::vector<std::array<double, 2>> polygon{};  // the visible region, in order; may reach far outside the scene
  std::vector<std::array<double, 2>> rays_to{};  // e.g. the vertices where the view jumps
};

// Two edges, their critical points, and lines between them. A: the edge whose critical points are shown.
struct PairDrawing2 {
  SheetText2 sheet{};
  Face a, b;  // may be of one surface, or the same
  std::string a_label = "A", b_label = "B";
  std::vector<std::array<double, 2>> critical_on_a{};
  std::vector<std::pair<std::array<double, 2>, std::array<double, 2>>> lines{};
};

// What is drawn of a point's view, and of what two faces see of each other. Towards the sky the region is drawn far
// beyond the picture; from within a solid only the eye. The sky is not drawn: its place is taken by the face, under it.
VisibilityDrawing2 drawing_of(const VisibilityPolygon2& polygon);
PairDrawing2 drawing_of(const PairSight2& sight);

// The size of the drawing on a sheet, and the drawing on a canvas of that size.
//
//   (1) the light lies over the floors and beneath the walls, translucent and warm
//   (2) the eye and all critical points are shown, outside the scene too; what reaches out of the picture is cut off
// Throws UsageError for a width out of range. REQUIRES that the drawing outlives this.
class VisibilityPainter2 {
 public:
  VisibilityPainter2(const PreparedScene2& prepared, const VisibilityDrawing2& drawing);
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
  std::uint32_t width() const { return sheet_.width(); }
  std::uint32_t height() const { return sheet_.height(); }
  void draw(PictureCanvas& canvas) const;

 private:
  void draw_edge(PictureCanvas& canvas, const Face& face, const std::string& label, const Colour& colour) const;

  const PairDrawing2& drawing_;
  SceneSheet2 sheet_;
};

// Return the bytes of the picture file. The sheet is as the drawing asks for.
std::string visibility_picture_2(const PreparedScene2& prepared, const VisibilityDrawing2& drawing,
                                 PictureFormat format);
std::string pair_picture_2(const PreparedScene2& prepared, const PairDrawing2& drawing, PictureFormat format);

}  // namespace hottel
