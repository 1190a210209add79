// Exact partial visibilities in space.
#pragma once

#include <memory>

#include "geometry/space/exchange/exchange.h"
#include "solver/methods/exact_visibility.h"

namespace hottel {

// Those of all pairs of elements, to the usual tolerance; 0 and 1 are decided by signs. COST: that of the exact
// factors.
inline std::shared_ptr<const ExactVisibility> exact_visibility_3(const PreparedScene3& prepared) {
  return std::make_shared<const ExactVisibility>(exact_exchange(prepared, {.granularity = Granularity::kElement}));
}

}  // namespace hottel
