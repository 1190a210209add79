// The direct exchange areas of all pairs of a convex room, where nothing can hide anything.
#pragma once

#include "geometry/plane/exchange/exchange_sums.h"

namespace hottel {

// What sum_visible_pairs returns, by Hottel's crossed strings: of faces a -> b and c -> d, |ac| + |bd| - |ad| - |bc|.
//
//   (1) as properties (1) and (2) of sum_visible_pairs: strings along a wall are the sums of its parts, so they cancel
//       to the last bit in every row
//   (2) the sums differ from those of the sweep by no more than their errors allow
// REQUIRES: is_convex_room() holds of the scene.
// COST: four strings for each pair of pieces.
PairSums2 sum_convex_pairs(const Arrangement2& arrangement, const ElementTable2& table);

}  // namespace hottel
