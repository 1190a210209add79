// Faces that see no sky, because something closed is around them. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/merged_occluders.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/stretches/surface_stretches.h"

namespace hottel {

// The sides of surfaces from which no line leaves the scene freely, as far as closed shells tell.
//
// A closed shell is all that hangs together by edges, where each edge has two polygons and these can be turned so that
// every edge is passed in both directions: convex or not, a room, a box, a room typed to six digits. Where its winding
// number is not 0 every line to the far meets it. The number is counted along one exact ray for all polygons of the
// shell, and one for each other polygon; it holds for each surface that no polygon of the shell stands on, or pierces.
// And where the boundary of the convex hull of the scene is covered, however divided, it closes the scene too
// (ClosedHull3).
//
//   (1) has() is true only of sides from no inner point of which a line leaves the scene freely. Exact
//   (2) it is true of all inner sides of shells that do not touch themselves along lines, and of what is in them and
//       has nothing of the shell standing on it, unless polygons of the shell times those in its box are more than a
//       million
//
// COST: n log n, and a microsecond for each polygon of a shell and each one in its box.
class NoSky3 {
 public:
  // Surfaces are those of `merged`. REQUIRES: it is made of the polygons, and the stretches are of its surfaces.
  NoSky3(const Occluders3& polygons, const MergedOccluders3& merged, const SurfaceStretches3& stretches);

  bool has(std::uint32_t surface, bool is_back) const { return sides_[is_back ? 1 : 0][surface]; }

 private:
  std::array<std::vector<bool>, 2> sides_;  // fronts, backs
};

}  // namespace hottel
