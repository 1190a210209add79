// The contours of a picture of light: lines of several levels, and their labels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/picture/canvas.h"
#include "viewer/picture/contours.h"

namespace hottel {

// Lines of the levels of a field, one after the other.
//
//   (1) no two lines cross or touch, and none crosses itself: those of contour_lines() do not, and what
//       simplified_line() makes of them is taken where it does not either
//   (2) lines too short to be told from a speck are left out: whose box is less than `least` pixels across
// COST: that of contour_lines(), and some microseconds a point.
struct Contour {
  double level = 0;
  PixelLine line;
};
std::vector<Contour> contour_set(const PixelField& field, std::span<const double> levels, double least);

// Draws the lines, moved by `origin`, and on each that has room for it one label: its level, as `names` has it.
//
//   (1) labels cover no other label, no wall and nothing outside of the field; nor other lines, where that can be
//   (2) as near to the middle of its line as that allows, a label lies on the line
// size: a text is some 13 of it high. REQUIRES a name for each contour.
void draw_contours(PictureCanvas& canvas, std::span<const Contour> contours, std::span<const std::string> names,
                   const PixelField& field, Pixel origin, double size);

}  // namespace hottel
