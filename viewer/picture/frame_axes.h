// Coordinates along the frame of a picture.
#pragma once

#include <string>

#include "viewer/picture/canvas.h"

namespace hottel {

// A rectangle of a picture, the coordinates at its sides, rising or falling evenly between them, and what stands after
// the last number of the lower side and above those of the left one.
struct AxesFrame {
  Pixel top_left, bottom_right;
  double left = 0, right = 1, lower = 0, upper = 1;
  std::string along{}, up{};
};

// Draws a line around the rectangle, ticks at round coordinates with their numbers below and on the left. unit: a text
// is some 14 of it high.
//
//   (1) no tick lies outside, and no two along a side have one label
//   (2) numbers that are wider than the room beside the rectangle are written smaller
//
// Nothing but the line where the coordinates of a side are not told apart by doubles.
void draw_frame_axes(PictureCanvas& canvas, const AxesFrame& frame, double unit);

}  // namespace hottel
