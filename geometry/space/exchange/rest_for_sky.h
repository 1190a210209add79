// What elements see of the sky where that could not be measured.
#pragma once

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/pair_sum.h"

namespace hottel {

// Gives elements whose pair with the sky could not be measured what their other pairs leave of their areas, where that
// is known within the tolerance, and more than its error: their rows then close by definition. Next to a small thing,
// or one that is very far from the others, doubles have too few digits for the far walls of the sky, and enough for
// these. REQUIRES all pairs of these elements, in order.
void take_rest_for_sky(const ElementTable3& table, double tolerance, PairSums3& sums);

}  // namespace hottel
