// The sky in parts. Internal to geometry/space/exchange.
#pragma once

#include <vector>

#include "geometry/space/arrangement/patch.h"
#include "geometry/space/unobstructed/unobstructed.h"

namespace hottel {

// Returns convex cones of directions that cover all that a patch sends light to: eight along its horizon, reaching a
// little below it, and four above. Borders between cones are no places at which anything is seen to begin or end, for
// directions do not change when what is seen is moved or grows.
//
//   (1) no two share more than a border; every direction on the front of the patch is in one of them
//   (2) they are the same for all patches of one normal, with integers below 2^9
std::vector<Patch3> sky_cones(const Patch3& patch);

// The measure of a patch and a cone of the sky with nothing between them: as unobstructed_measure() says, but for (2),
// and (3) within 2^-46 of the area.
UnobstructedMeasure3 unobstructed_sky(const Vertices3& vertices, const Patch3& patch, const Patch3& cone);

}  // namespace hottel
