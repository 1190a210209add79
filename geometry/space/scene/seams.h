// Outlines that run to their holes and back.
#pragma once

#include "geometry/space/scene/polygon.h"

namespace hottel {

// Takes the holes out of the outline of a polygon, where it runs to them and back along seams, in which it has the same
// sides one way and the other: formats that know no holes are written so. Returns whether there were any.
//
//   (1) a seam is a side or a chain of them, from the outline to a hole or from hole to hole
//   (2) the area is the same, and so is the front; the outline begins with the corner that comes first
//   (3) nothing is changed where a loop that is left goes the same way round as the outline, or the outline goes back
//       along itself at a corner: that is no hole
//
// COST: n log n for n corners, and as much again for each hole.
bool open_seams(Polygon3& polygon);

}  // namespace hottel
