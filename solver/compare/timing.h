// How long a computation takes, when it is repeated.
#pragma once

#include <functional>
#include <optional>

#include "solver/compare/method_report.h"

namespace hottel {

// Runs a computation again and again; `run` does it once and returns the seconds it took.
//
//   (1) the first run warms up and is not counted, unless it took more than a second: then caches do not matter
//   (2) it is repeated until three runs are counted that took half a second together, but not beyond ten seconds and
//       not more than a thousand times; with `runs`, exactly so many times after the warm-up
//   (3) of an even number of runs the median is the mean of the middle two
// REQUIRES runs >= 1.
Timing time_repeatedly(const std::function<double()>& run, const std::optional<int>& runs = {});

}  // namespace hottel
