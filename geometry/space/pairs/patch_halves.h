// Patches cut in two.
#pragma once

#include <array>

#include "geometry/space/arrangement/patch.h"

namespace hottel {

// Returns two patches that together are the patch and share no area: it is cut from the middle of its longest side to
// the middle of the side opposite, or the corner opposite where it has an odd number of sides.
//
//   (1) exact; the first corners of the halves are on the cut
std::array<Patch3, 2> halves_of(const Patch3& patch);

// The square of the length of the longest side, in the unit of integer forms times 2^-shift.
double longest_side_squared(const Patch3& patch, long shift);

}  // namespace hottel
