// Planes of bodies in doubles. Internal to geometry/space.
#pragma once

#include "geometry/space/visibility/direction.h"

namespace hottel {

// A plane that a body has on one side, the one where heights are negative.
struct OutwardPlane3 {
  Direction3 outward;  // a unit normal
  double offset;
  double height(const Direction3& p) const { return dot(outward, p) - offset; }
};

}  // namespace hottel
