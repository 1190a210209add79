// The solid that a point is in.
#pragma once

#include <cstdint>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// Returns the first listed group with a solid that is seen from the point; Solids2::kNone where the point is not in
// the interior of the union of all solids.
//
//   (1) a point on the border of a solid is in none, also where several solids meet, unless all sides around
//       it are covered
//   (2) a point that sees the sky, or nothing at all, is in none
//
// REQUIRES: the view from the point. COST: linear in what it sees; nothing where nothing is solid.
std::uint32_t solid_around(const Arrangement2& arrangement, const View2& view);

}  // namespace hottel
