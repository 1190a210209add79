// Exact partial visibilities in the plane.
#pragma once

#include <memory>

#include "geometry/plane/exchange/exchange.h"
#include "solver/methods/exact_visibility.h"

namespace hottel {

// Those of all pairs of elements, correctly rounded. COST: that of the exact factors.
inline std::shared_ptr<const ExactVisibility> exact_visibility_2(const PreparedScene2& prepared) {
  return std::make_shared<const ExactVisibility>(exact_exchange(prepared, {.granularity = Granularity::kElement}));
}

}  // namespace hottel
