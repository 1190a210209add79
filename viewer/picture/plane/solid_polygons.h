// Solids as they are drawn: their outlines, and the hatching inside.
#pragma once

#include <span>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/frame.h"

namespace hottel {

// Returns a polygon for each connected region of the interior of the union of all solids (solid_regions.h), the solid
// on one side of it throughout. A hole is reached along a line that is walked there and back, and so is not seen.
std::vector<std::vector<Pixel>> solid_polygons(const Arrangement2& arrangement, const Frame2& frame);

// Draws lines that rise to the right inside a polygon, `spacing` apart along the axes. Lines of neighbouring polygons
// meet. Inside by the even-odd rule; nothing is drawn for an empty polygon, nor far outside the
// canvas. REQUIRES spacing > 0. COST: that of what is on the canvas, however large the polygon.
void draw_hatch_2(PictureCanvas& canvas, std::span<const Pixel> outline, double spacing, double line_width,
                  Colour colour);

}  // namespace hottel
