// Lines along which a field of pixels has one value.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/picture/canvas.h"

namespace hottel {

// Values at the centres of the pixels of a picture, the top row first; NaN where there is none. Cut: one entry for each
// square between four centres, (width - 1) by (height - 1), where no line may run, since a wall does.
struct PixelField {
  std::uint32_t width = 0, height = 0;
  std::vector<float> values;
  std::vector<bool> cut;
};

// Cuts the squares that come near an edge, of which values differ on its two sides. a, b: its ends in the picture, in
// which the field begins at `origin`.
void cut_along(Pixel a, Pixel b, Pixel origin, PixelField& field);

// A line in the picture, from end to end; closed where both ends are one point.
using PixelLine = std::vector<Pixel>;

// Returns the lines of a level, by interpolation along the sides of the squares between four centres (marching
// squares).
//
//   (1) at each point of a line the value, blended along the side of the square that it lies on, is the level
//   (2) no line enters a square that is cut, or that has a corner without a value; lines end there
//   (3) a corner exactly at the level counts as above it
// COST: a few ns a pixel.
std::vector<PixelLine> contour_lines(const PixelField& field, double level);

// Returns the line with fewer points, none of the old ones farther than `tolerance` from it (Douglas, Peucker 1973).
PixelLine simplified_line(std::span<const Pixel> line, double tolerance);

// Returns round levels inside (lower, upper), ascending, at most `limit`: multiples of 1, 2 or 5 times a power of ten
// where upper is below ten times lower; else 1, 2, 5, 10, 20, ..., or when these are too many 1, 3, 10, 30, ..., or
// whole decades, every few of them when there are many. REQUIRES finite lower <= upper, limit > 0. Nothing where upper
// <= 0 or they are equal.
std::vector<double> contour_levels(double lower, double upper, int limit);

}  // namespace hottel
