// What stands between two patches. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/between/pair_geometry.h"
#include "geometry/space/between/pair_visibility.h"
#include "geometry/space/hiding/hiders.h"

namespace hottel {

// A half space in doubles of Vertices3.
struct HullHalfSpace3 {
  double x, y, z, offset;
  double height(const Direction3& p) const { return x * p.x + y * p.y + z * p.z + offset; }
};

// Two patches with all surfaces that may stand between them, and how they are settled.
//
//   (1) hidden: one is not in front of the other, or one surface stands between each two of their points: exact
//   (2) a surface that is not among the bodies hides nothing: it is not in front of both patches, or it does not come
//       between their planes, or it is outside their common convex hull: exact
//   (3) clear iff none is among the bodies
//
// Where it is known which surfaces are never first from patch i (FirstMet3) these are left out, as if they were not
// there: what the others hide is all that is hidden. And convex bodies hide as one (PairGeometry3::Solid), and what
// hangs together (PairGeometry3::hides_joined).
struct PairOccluders3 {
  PairGeometry3 bodies;
  PairVisibility3 sight = PairVisibility3::kHidden;
  // Planes beside which the hull of both patches lies: through two corners of one and one of the other, which are
  // the points of the plane, the first of them not far; the hull is on the side `inside`.
  struct HullPlane {
    PairGeometry3::Plane plane;
    int inside;
  };
  std::vector<HullPlane> hull;
  // The same in doubles of Vertices3, where these tell them: the hull is where no height is negative, rounding
  // included.
  std::vector<HullHalfSpace3> half_spaces;
  // Of the surfaces near the hull those that are never first from patch i, ascending: they are taken for not there. One
  // that shares an edge with a body, and that no line between the patches meets, is not among them.
  std::vector<std::uint32_t> left_out;

  // Takes all surfaces whose boxes are near the hull; without those that `first_met` says, where it is not null.
  PairOccluders3(const Occluders3& occluders, const SurfaceBoxes3& boxes, const KnownPatch3& i, const KnownPatch3& j,
                 FirstMet3* first_met = nullptr);
  PairOccluders3(const Occluders3& occluders, const SurfaceBoxes3& boxes, const Patch3& i, const Patch3& j,
                 FirstMet3* first_met = nullptr);
  // The setting of parts of two patches: takes what stands between the whole patches.
  PairOccluders3(const Occluders3& occluders, const PairOccluders3& whole, const Patch3& i, const Patch3& j);

  std::size_t count_between() const { return bodies.end_of_between() - 2; }

 private:
  bool can_see() const;
  void find_between(const Occluders3& occluders, const SurfaceBoxes3& boxes, FirstMet3* first_met);
  void find_hull(const Vertices3& vertices);
  void add_bodies(const Occluders3& occluders, std::span<const std::uint32_t> near);
  void keep_left_out_at_lines(const Occluders3& occluders);
  void add_solids(const Occluders3& occluders);
  void add_half_space(const HullPlane& plane, double unit_ratio);
  void add_hull_planes(std::uint32_t of_edges, std::uint32_t of_points);
  bool may_stand_between(std::uint32_t body) const;
  bool is_beside_hull(std::uint32_t body) const;
  bool hides_all(std::uint32_t body) const;

  double reach_ = 0;                       // the largest coordinate of a surface
  const ConvexBodies3* solids_ = nullptr;  // that hide as one; null: none do
};

}  // namespace hottel
