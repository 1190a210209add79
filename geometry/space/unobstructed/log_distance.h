// The mean logarithm of the distance of two straight edges, with proven bounds.
#pragma once

#include <optional>

#include "geometry/space/unobstructed/edge_pair.h"

namespace hottel {

// What is known exactly of two edges.
//   kNone:     nothing
//   kJoint:    e(0) = f(0), and they are not parallel
//   kEndOn:    e(0) lies on f between its ends, and they are not parallel
//   kParallel: they are parallel, maybe on one line, maybe with points in common
enum class EdgeContact3 : unsigned char { kNone, kJoint, kEndOn, kParallel };

// Both functions return J, the integral of ln |f(t) - e(s)| over all s and t in [0, 1].
//
//   (1) |value - J| <= error: proven, given that log and atan2 are within 4 units of the last place
//   (2) error is tolerance and what rounding makes, some 20 to 100 roundoffs for edges of about the same size. Where
//       edges come near each other without touching (less than 2^-40 of their size) it may be more.
//
// Real is double, long double or WideReal. Nothing is returned where edges are not so far apart that a few nodes are
// enough. COST: 0.2 to 1 microseconds in double.
template <class Real>
std::optional<Approximation<Real>> mean_log_of_distant(const EdgePair3<Real>& pair, double tolerance);

// COST: 0.2 to 1 microseconds where they touch as `contact` tells, 3 to 30 where they are near each other.
// SEE: docs/design/space/unobstructed.md
template <class Real>
Approximation<Real> mean_log_of_near(const EdgePair3<Real>& pair, EdgeContact3 contact, double tolerance);

}  // namespace hottel
