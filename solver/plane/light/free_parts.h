// Where in the plane there is light to speak of: not in solids, and not outside a closed scene.
#pragma once

#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// The triangles of an arrangement, and what lies outside of all, by whether there is light to speak of.
//
//   (1) none in the interior of the union of solids
//   (2) where the scene promises to be closed, none in a region, the unbounded one too, that no side with a material
//       looks into: from nowhere in it such a side is seen
// COST: linear in the triangles; next to nothing in a scene without solids that makes no promise.
class FreeParts2 {
 public:
  explicit FreeParts2(const PreparedScene2& prepared);

  bool has_all() const { return is_free_.empty(); }
  bool has(TriangleId triangle) const { return has_all() || is_free_[triangle.index()] != 0; }
  bool has_outside() const { return has_outside_; }
  // What the triangle of a half-edge and that on its other side are.
  bool has(HalfEdgeId h) const { return has(triangle_of(h)); }
  bool has_beyond(const Triangulation2& triangulation, HalfEdgeId h) const {
    const HalfEdgeId other = triangulation.across(h);
    return other.is_none() ? has_outside_ : has(other);
  }

 private:
  void leave_out_dark_regions(const PreparedScene2& prepared);

  std::vector<char> is_free_;  // by triangle; empty where all are
  bool has_outside_ = true;
};

}  // namespace hottel
