// How fast this machine is, for estimates of time.
#pragma once

namespace hottel {

// Returns how long this machine takes for view factors over what the machine takes that the seconds of plans were
// measured on: 2 is half as fast.
//
//   (1) what HOTTEL_SPEED in the environment says, where it is a positive number: estimates are the same everywhere
//   then (2) else what was measured by an earlier run of this version, and kept in $XDG_CACHE_HOME/hottel/speed, or
//       ~/.cache/hottel/speed
//   (3) else it is measured now, in about a hundredth of a second, and kept; where it cannot be, nothing is said of it
// Does not throw. COST: reading a small file.
double machine_speed() noexcept;

}  // namespace hottel
