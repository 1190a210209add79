// What elements see of the sky, told by what they see of all else.
#pragma once

#include <vector>

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/pair_sum.h"

namespace hottel {

// Gives elements whose pair with the sky could not be measured what their other pairs leave of their areas, where that
// is known within the tolerance, and more than its error: their rows then close by definition. REQUIRES all pairs of
// these elements, in order.
void take_rest_for_sky(const ElementTable3& table, double tolerance, PairSums3& sums);

// Narrows the bounds of what elements see of the sky to what their other pairs leave of their areas: proven as well as
// these are. Numbers that are outside are moved to the nearer bound. REQUIRES all pairs that are not 0.
void enclose_sky(const ElementTable3& table, std::vector<PairSum3>& pairs);

}  // namespace hottel
