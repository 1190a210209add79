// Twice the direct exchange areas of chosen pairs, as exact sums of square roots.
#pragma once

#include <utility>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/prepared/element_table.h"
#include "kernel/root_sum.h"

namespace hottel {

// Returns 2 S(i, j) in integer form for each of the pairs, in their order.
//
//   (1) canonical: is_zero() iff the terms of the pair cancel, decided without rounding
//   (2) (j, i) has the sum of (i, j); a pair that is asked for twice has the same sum twice
//   (3) a pair (i, i), of groups, counts both directions of a line
//   (4) a pair of which neither has a row has the sum 0
//
// COST: a second sweep, about the vertices only that lie between the two labels of some pair (about all
// swept_vertices() when a pair contains the sky or there are very many), then one canonical sum a pair.
std::vector<RootSum> exact_sums(const Arrangement2& arrangement, const ElementTable2& table,
                                const std::vector<ElementPair>& pairs);

}  // namespace hottel
