#include "solver/plan.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {

bool Plan::uses(const std::string& effect) const {
  const auto place =
      std::find_if(effects_.begin(), effects_.end(), [&](const PlannedEffect& e) { return e.effect == effect; });
  HOTTEL_REQUIRE(place != effects_.end());
  return place->used;
}

}  // namespace hottel
