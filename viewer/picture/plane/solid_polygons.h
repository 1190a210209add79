// Solids as they are drawn.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/frame.h"

namespace hottel {

// Returns a polygon for each connected region of the interior of the union of all solids (solid_regions.h), the solid
// on one side of it throughout. A hole is reached along a line that is walked there and back, and so is not seen.
std::vector<std::vector<Pixel>> solid_polygons(const Arrangement2& arrangement, const Frame2& frame);

}  // namespace hottel
