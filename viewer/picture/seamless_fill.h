// Polygons beside each other, filled so that nothing shines through between them.
#pragma once

#include <span>
#include <vector>

#include "viewer/picture/canvas.h"

namespace hottel {

// Polygons of one colour.
struct ColouredPolygons {
  Colour colour;
  std::vector<std::vector<Pixel>> polygons;
};

// Draws, below what is filled next, the same polygons half a pixel larger, within the border of all of them: renderers
// mix colours at the borders of polygons, and so the ground would shine through where two meet. The mark is kPaper.
// REQUIRES polygons that are convex, go around in one sense and share no area.
void fill_below(PictureCanvas& canvas, std::span<const ColouredPolygons> fills);

// Returns the convex polygon that holds, of each corner, the square of this half side around it: it holds all that is
// so near to the polygon along both axes, and nothing else. Counter-clockwise as y goes up. COST: n log n.
std::vector<Pixel> grown_polygon(std::span<const Pixel> polygon, double half_side);

}  // namespace hottel
