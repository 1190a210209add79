// The corners of what a moving point sees. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>

#include "geometry/space/vectors/moving_vector.h"
#include "geometry/space/visibility/eye_plane.h"

namespace hottel {

// The end of an edge of a moving fragment (see ConeCorner3).
struct MovingCorner3 {
  static constexpr std::uint32_t kNoPoint = 0xffffffff;

  MovingVector3 direction;
  PlaneSide3 plane;                // of the edge that begins here
  std::uint32_t point = kNoPoint;  // the direction to it, or the opposite
  bool is_antipode = false;
  PlaneSide3 first, second;  // where there is no point: the direction is the product of their normals
};

}  // namespace hottel
