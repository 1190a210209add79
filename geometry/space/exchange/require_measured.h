// The refusal of pairs in space that could not be measured.
#pragma once

#include <vector>

#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// Throws UnmeasuredPairs, naming the first of them and what was reached, unless there are none. Where all of them
// reached some tolerance it advises one.
void require_measured(const PreparedScene3& prepared, const ElementTable3& table, double tolerance,
                      const std::vector<FailedPair3>& failures);

}  // namespace hottel
