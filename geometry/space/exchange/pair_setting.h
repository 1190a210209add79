// What stands between two patches. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/exchange/pair_bodies.h"
#include "geometry/space/exchange/sight.h"
#include "geometry/space/exchange/surface_stretches.h"

namespace hottel {

// Two patches with all surfaces that may stand between them, and how they are settled.
//
//   (1) hidden: one is not in front of the other, or one surface stands between each two of their points: exact
//   (2) a surface that is not among the bodies hides nothing: it is not in front of both patches, or it does not come
//       between their planes, or it is outside their common convex hull: exact
//   (3) clear iff none is among the bodies
struct PairSetting3 {
  PairBodies3 bodies;
  Sight3 sight = Sight3::kHidden;
  // Planes beside which the hull of both patches lies: through two corners of one and one of the other, which are
  // the points of the plane; the hull is on the side `inside`.
  struct HullPlane {
    PairBodies3::Plane plane;
    int inside;
  };
  std::vector<HullPlane> hull;

  PairSetting3(const Blockers3& blockers, const SurfaceBoxes3& boxes, const Patch3& i, const Patch3& j);

 private:
  void find_hull();
  void add_hull_planes(std::uint32_t of_edges, std::uint32_t of_points);
  bool may_stand_between(std::uint32_t body) const;
  bool is_beside_hull(std::uint32_t body) const;
  bool hides_all(std::uint32_t body) const;
};

}  // namespace hottel
