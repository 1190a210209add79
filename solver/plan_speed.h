// A plan on a machine that is faster or slower than the one its seconds were measured on.
#pragma once

#include "solver/plan.h"

namespace hottel {

// Returns the plan with all estimates times `slowness`: 2 on a machine half as fast. REQUIRES slowness > 0.
Plan plan_at_speed(const Plan& plan, double slowness);

}  // namespace hottel
