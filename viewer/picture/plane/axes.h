// Coordinates along the frame of a picture of the plane.
#pragma once

#include <string>

#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/frame.h"

namespace hottel {

// The room that axes take around a picture, in units (of which a text is some 14 high).
inline constexpr SheetMargins2 kAxesMargins2{.left = 78, .right = 26, .top = 22, .bottom = 62};

// Draws a line around the region of the frame, ticks at round coordinates of the scene, in doubles, with their numbers
// below and on the left, and after the last number of x the unit of length.
//
//   (1) no tick lies outside the region, and no two along a side have one label
//   (2) numbers that are wider than the room beside the frame are written smaller
//
// Nothing but the line where the coordinates of a side are not told apart by doubles.
void draw_axes_2(PictureCanvas& canvas, const Frame2& frame, double unit, const std::string& length_unit);

}  // namespace hottel
