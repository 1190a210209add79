// How fast this machine is, for estimates of time.
#pragma once

#include "solver/plan_speed.h"

namespace hottel {

// Returns how long a core of this machine takes for view factors over what one of the machine takes that the seconds of
// plans were measured on, and how many threads may work (ThreadLimit).
//
//   (1) what HOTTEL_SPEED in the environment says, where it is a positive number, and one thread: then estimates are
//       the same everywhere
//   (2) else what was measured by an earlier run of this version, and kept in $XDG_CACHE_HOME/hottel/speed, or
//       ~/.cache/hottel/speed
//   (3) else it is measured now, in about a hundredth of a second of the processor, and kept; where it cannot be,
//   nothing is said of it
// Does not throw. COST: reading a small file.
MachineSpeed machine_speed() noexcept;

}  // namespace hottel
