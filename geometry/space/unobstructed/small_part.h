// The direct exchange area of a patch and one that is small against its distance from the edges of the first.
#pragma once

#include <optional>

#include "geometry/space/unobstructed/local_pair.h"
#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// Returns S, in squares of local coordinates times 2^-exponent, by quadrature over the smaller one: the factor from a
// point to the other one in closed form (Lambert), in long doubles. Nothing is returned where no small number of nodes
// is within `error`.
//
//   (1) |value - S| <= error of the result: proven, given that atan2 is within 4 units of the last place
//   (2) the error is some 20 roundoffs of the smaller area, however large the other one is, times the distance of its
//       corners over that of its edges
//
// REQUIRES: they face each other. COST: 10 to 50 microseconds.
std::optional<Approximation<long double>> measure_of_small(const LocalPair3& pair, int exponent, double error);

}  // namespace hottel
