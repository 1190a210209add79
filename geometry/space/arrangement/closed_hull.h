// Faces that see no sky, because walls close the scene.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/occluders.h"

namespace hottel {

// Whether polygons cover all of the boundary of the convex hull of a scene, and which faces are then within.
//
//   (1) sees_no_sky() is true only of faces from no inner point of which a line leaves the scene freely. Exact
//   (2) where the boundary is covered, however divided and whichever side of the walls is inside, it is true of all
//       faces but the outer sides of the walls, and the sides towards the outside of what lies in their planes
//   (3) else it is true of none
//
// COST: a sign for each distinct plane and vertex at worst, few for polygons within; n log n for the outlines.
class ClosedHull3 {
 public:
  explicit ClosedHull3(const Occluders3& occluders);

  bool is_closed() const { return is_closed_; }
  // Whether all polygons are walls with their fronts inward: one closed convex room.
  bool is_room() const { return is_closed_ && std::find(backs_.begin(), backs_.end(), true) == backs_.end(); }
  bool sees_no_sky(std::uint32_t surface, bool is_back) const {
    return is_closed_ && (is_back ? backs_ : fronts_)[surface];
  }

 private:
  bool is_closed_ = false;
  std::vector<bool> fronts_, backs_;  // whether vertices of the scene are before a polygon, and behind
};

}  // namespace hottel
