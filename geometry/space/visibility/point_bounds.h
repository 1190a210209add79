// What a point sees of each face, with proven bounds.
#pragma once

#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "kernel/enclosure.h"

namespace hottel {

// Parts of the full sphere, and view factors, as VisibilityMap3 has them.
struct PointBounds3 {
  struct Share {
    Face face;
    Enclosure fraction{0, 0};
    Enclosure factor{0, 0};  // where there is a normal, else 0
  };
  std::vector<Share> shares;  // of the faces that are seen, in order
  Enclosure sky_fraction{0, 0}, sky_factor{0, 0};
};

// Returns what is seen from the eye of a map: in all directions, or in the half space of a normal.
//
//   (1) all numbers are within their bounds: proven, by balls around the angles between exact directions
//   (2) bounds of shares are two units of the last place apart at most, those of the sky some 1e-30 absolutely
//   (3) shares are those of faces_seen_from(), or of with_owners() and map_from(); of these all numbers are within
//       1e-14 of the bounds
//   (4) what leads into solids from a point of their border is of no share, nor of the sky
//
// REQUIRES: the map is of the pieces of the arrangement, and not of a sun; a normal that is not zero.
// COST: some twenty microseconds a corner.
PointBounds3 point_bounds(const ExactVisibilityMap3& map, const Arrangement3& arrangement,
                          const std::optional<Vector3>& normal = std::nullopt);

}  // namespace hottel
