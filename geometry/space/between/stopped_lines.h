// Lines between two patches that a body surely stops. Internal to geometry/space.
#pragma once

#include <cstdint>

#include "geometry/space/between/pair_geometry.h"

namespace hottel {

// Returns whether a line from a corner of one patch to a corner of the other one passes within a body, between them,
// and leaves both before their fronts: then lines of a measure above 0 do, S < S0. Exact; what it does not find, other
// lines may tell. COST: some 50 ns for each two corners and side of the body.
bool stops_lines_of_corners(const PairGeometry3& bodies, std::uint32_t body);

}  // namespace hottel
