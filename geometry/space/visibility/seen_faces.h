// Which faces of a scene a point sees, where its polygons are several pieces.
#pragma once

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/visibility/point_map.h"

namespace hottel {

// Returns a map that was made of the pieces of an arrangement, its faces those of the scene: the owners of the sides
// of pieces. Fragments are by these faces, and a face has one share.
PointMap3 with_owners(PointMap3 map, const Arrangement3& arrangement);

}  // namespace hottel
