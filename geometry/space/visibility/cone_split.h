// How a plane through the eye divides a convex cone. Internal to geometry/space.
#pragma once

#include <cstddef>
#include <span>

#include "geometry/space/visibility/eye_plane.h"

namespace hottel {

// Sets `inside` and `outside`, where they are not null, to what of a fragment is on the positive side of a plane, and
// on the other one. A fragment is a list of corners in order (ConeFragment3): each has the plane of the edge that
// begins at it, and planes.corner(first, second) is where the edge on one plane ends and that on the next one begins.
// REQUIRES: `signs` are those of the corners beside the plane, and both signs occur.
//
// The boundary changes sides twice, at a corner or within an edge. Where the plane takes over, its edge begins at the
// point of change.
template <class Planes, class Fragment>
void split_cone(Planes& planes, const Fragment& fragment, std::span<const signed char> signs, PlaneSide3 side,
                Fragment* inside, Fragment* outside) {
  const std::size_t count = fragment.size();
  if (inside) inside->clear();
  if (outside) outside->clear();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const int here = signs[k], there = signs[next];
    const auto& corner = fragment[k];
    if (inside && (here > 0 || (here == 0 && there > 0))) inside->push_back(corner);
    if (outside && (here < 0 || (here == 0 && there < 0))) outside->push_back(corner);
    if (here > 0 && there < 0) {
      auto change = planes.corner(corner.plane, side);
      if (inside) inside->push_back(change);
      change.plane = corner.plane;
      if (outside) outside->push_back(change);
    } else if (here < 0 && there > 0) {
      auto change = planes.corner(side, corner.plane);
      if (inside) inside->push_back(change);
      change.plane = side.opposite();
      if (outside) outside->push_back(change);
    } else if (there == 0 && here != 0) {
      auto change = fragment[next];
      change.plane = here > 0 ? side : side.opposite();
      if (here > 0 && inside) inside->push_back(change);
      if (here < 0 && outside) outside->push_back(change);
    }
  }
}

}  // namespace hottel
