// The arcs that bound what is seen along a part of a stretch. Internal to geometry/space.
#pragma once

#include <span>

#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/proven/part_vector.h"

namespace hottel {

// The sum over arcs of count / 2 (moment . n) / |n| times the angle from corner b to corner e about the normal n, along
// a part: the formula of the integrand.
struct PartArcs3 {
  std::span<const SeenArc3> arcs;
  std::span<const PartVector3> planes, corners;
  LocalVector3<double> moment;
  double moment_off = 0, moment_size = 0;  // how far it is off, as a vector; no less than its length
};

}  // namespace hottel
