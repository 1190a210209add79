// What a store of factors means for a plan.
#pragma once

#include <string>

#include "solver/plan.h"

namespace hottel {

// The name of the effect.
inline constexpr const char* kStoreEffect = "store";

// Returns the plan with a last effect: factors are kept. Its reason says whether that saves time, by what was measured
// (docs/store.md): in space it does, in the plane exact factors take about as long to read as to compute.
Plan plan_with_store(const Plan& plan, bool is_in_space, const std::string& method);

}  // namespace hottel
