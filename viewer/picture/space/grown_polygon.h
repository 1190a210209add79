// Polygons made a little larger.
#pragma once

#include "viewer/picture/space/pixel_values.h"

namespace hottel {

// Returns the convex polygon that holds, of each corner, the square of this half side around it: it holds all that is
// so near to the polygon along both axes, and nothing else. Counter-clockwise as y goes up. COST: n log n.
PixelPolygon grown_polygon_3(const PixelPolygon& polygon, double half_side);

}  // namespace hottel
