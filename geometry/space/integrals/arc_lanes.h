// The sum over the arcs that bound what is seen, at many points at once. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/vectors/moving_vector.h"

namespace hottel {

// How many points are taken at once.
inline constexpr std::size_t kLanes3 = 16;
using Lanes3 = std::array<double, kLanes3>;
struct VectorLanes3 {
  Lanes3 x, y, z;
};

// What sum_of_arcs() gives of `arcs` between unit vectors along `corners`, on planes with normals along `planes`, at t
// = from + offset for each of the offsets, and what it may have lost at most.
//
//   (1) no vector is zero: the numbers are those of sum_of_arcs(), bit for bit, on every processor. Normals matter only
//       where corners are not close to each other at some of these points
//   (2) else it returns false
//
// COST: some 10 ns a corner, 15 ns an arc; where corners are not close 10 ns a plane and 40 ns an arc; where they are
// at some points alone, all of it.
bool sum_of_arcs_in_lanes(std::span<const SeenArc3> arcs, std::span<const MovingVector3> corners,
                          std::span<const MovingVector3> planes, double from, const Lanes3& offsets, VectorLanes3& sums,
                          Lanes3& rounding);

}  // namespace hottel
