// What a point sees, and what two edges see of each other, as drawings.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/face.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/plane/scene_picture.h"

namespace hottel {

struct PairSight2;
struct PreparedScene2;
struct VisibilityPolygon2;

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

// Return the bytes of the picture file. The sheet is as the drawing asks for.
std::string visibility_picture_2(const PreparedScene2& prepared, const VisibilityDrawing2& drawing,
                                 PictureFormat format);
std::string pair_picture_2(const PreparedScene2& prepared, const PairDrawing2& drawing, PictureFormat format);

}  // namespace hottel
