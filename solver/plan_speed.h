// A plan on a machine that is faster or slower than the one its seconds were measured on.
#pragma once

#include "solver/plan.h"

namespace hottel {

// slowness: 2 where a core is half as fast as one of the machine of the constants.
struct MachineSpeed {
  double slowness = 1;
  int threads = 1;
};

// Returns the plan with all estimates times the slowness, and those of what works on all threads (exchange, occlusion,
// sky, illumination) divided by their number, but for a tenth that one thread does. REQUIRES slowness > 0, threads
// >= 1.
Plan plan_at_speed(const Plan& plan, const MachineSpeed& speed);

// The seconds of one thing that works on all threads, as plan_at_speed() tells them.
double shared_seconds(double seconds, const MachineSpeed& speed);

}  // namespace hottel
