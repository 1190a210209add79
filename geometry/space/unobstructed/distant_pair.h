// The direct exchange area of two patches that are small against their distance.
#pragma once

#include <optional>

#include "geometry/space/unobstructed/local_pair.h"
#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// Returns S, in squares of local coordinates times 2^-exponent, by quadrature over both areas; nothing where the
// patches are not so distant that a few nodes are enough (about five times their size).
//
//   (1) |value - S| <= error: proven. Quadrature may be off by some 1e-14 of S, or by about `relative` times S where
//       that is more
//   (2) no number is subtracted from another of about its size: the error is some 1e-14 of S where the patches face
//       each other, and more where one of them is almost in the plane of the other
//
// REQUIRES: they face each other.
// COST: from half a microsecond, where they are far from each other, to 20.
std::optional<Approximation<double>> measure_of_distant(const LocalPair3& pair, int exponent, double relative);

}  // namespace hottel
