// Hatching: how the insides of solids are drawn.
#pragma once

#include <span>

#include "viewer/picture/canvas.h"

namespace hottel {

// Draws lines that rise to the right inside a polygon, `spacing` apart along the axes. Lines of neighbouring polygons
// meet.
void draw_hatch(PictureCanvas& canvas, std::span<const Pixel> outline, double spacing, double line_width,
                Colour colour);

}  // namespace hottel
