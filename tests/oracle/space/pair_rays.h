// The exchange of two polygons by rays: slow, obvious, and wrong only by chance.
#pragma once

#include <cstdint>

#include "tests/oracle/space/flat_polygon.h"

namespace hottel::oracle {

struct RayEstimate {
  double measure = 0;         // of S = A_i F_ij
  double standard_error = 0;  // from the spread of its batches, and of few rays from their number
  std::uint64_t seen = 0;     // rays that arrive
};

// Sends rays from points of i, thick where light is: S is the area of i times the share that meets the front of j
// before anything else. Points and directions fill their space evenly, shifted at random in each of 32 batches.
//
// A ray that only touches a polygon is not held up, and one in its plane neither: such rays are a null set.
// COST: 10 ns a ray and polygon.
RayEstimate exchange_by_rays(const FlatPair& pair, std::uint64_t seed, std::uint64_t rays);

}  // namespace hottel::oracle
