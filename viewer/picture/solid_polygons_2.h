// Solids as they are drawn.
#pragma once

#include <vector>

#include "geometry/arrangement/arrangement_2.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/frame_2.h"

namespace hottel {

// Returns a polygon for each connected region of the interior of the union of all solids (solid_regions_2.h), the solid
// on one side of it throughout. A hole is reached along a line that is walked there and back, and so is not seen.
std::vector<std::vector<Pixel>> solid_polygons(const Arrangement2& arrangement, const Frame2& frame);

}  // namespace hottel
