// Twice the exchange measures of chosen pairs, as exact sums of square roots.
#pragma once

#include <utility>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/exchange/element_table.h"
#include "kernel/root_sum.h"

namespace hottel {

// Returns 2 S(i, j) in integer form for each of the pairs, in their order.
// COST: a second sweep, about the vertices only that lie between the two labels of some pair (about every vertex when
// a pair contains the sky or there are very many), then one canonical sum a pair.
std::vector<RootSum> exact_sums(const Arrangement2& arrangement, const ElementTable2& table,
                                const std::vector<ElementPair>& pairs);

}  // namespace hottel
