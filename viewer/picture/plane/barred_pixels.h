// Which of many pixels are barred from a place by walls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hottel {

// A wall in a picture; in the units of its pixels' places.
struct Wall2 {
  double ax, ay, bx, by;
  double on_line;  // what side() may have where a place counts as on the line of the wall
};

// Twice the signed area of the triangle a, b, p.
inline double side(double ax, double ay, double bx, double by, double px, double py) {
  return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

// A rectangle of pixels: their places along x and y, ascending.
struct PixelBlock2 {
  std::span<const double> x, y;
};

// Sets the bits `bit` in marks[j * stride + i] for every pixel (x[i], y[j]) of the block that some wall bars from
// `centre`: pixel and centre lie strictly on two sides of the wall, and its ends on two sides of the line through both.
// A centre on a wall is barred from everything.
//
//   (1) each pixel is marked as if it was tested against each wall by itself, in doubles
// `walls` are numbers of walls in `all`.
// COST: a block that one wall bars as a whole, or that no wall comes near, is marked at once; others are divided: about
// the number of walls, and for each pixel where a shadow ends a few walls near it.
void mark_barred(const std::vector<Wall2>& all, std::span<const std::uint32_t> walls, const PixelBlock2& block,
                 double centre_x, double centre_y, std::uint8_t bit, std::size_t stride, std::uint8_t* marks);

}  // namespace hottel
