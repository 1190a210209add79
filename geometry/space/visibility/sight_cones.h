// Round cones around what an eye sees, to tell what cannot hide what. Internal to geometry/space/visibility.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/visibility/eye_planes.h"

namespace hottel {

// A round cone at the eye and two distances, around a polygon or around many.
struct SightCone3 {
  double x = 0, y = 0, z = 0;         // unit axis
  double cosine = -1, sine = 0;       // of the half angle; cosine -1: no direction is excluded
  double nearest = 0, farthest = -1;  // farthest -1: around nothing

  bool is_empty() const { return farthest < 0; }
  bool is_wide() const { return cosine < 0; }
};

// False only where nothing in `blocker` can hide anything in `target`: for both by themselves, the rounding of all
// doubles included.
inline bool may_hide(const SightCone3& blocker, const SightCone3& target) {
  if (blocker.is_empty() || blocker.nearest > target.farthest) return false;
  if (blocker.is_wide() || target.is_wide()) return true;
  constexpr double kSlack = 1e-9;
  return blocker.x * target.x + blocker.y * target.y + blocker.z * target.z >=
         blocker.cosine * target.cosine - blocker.sine * target.sine - kSlack;
}

// The cones of all polygons that the eye is not in the plane of, and of the nodes of their tree.
//
//   (1) everything in a polygon is within its cone and between its distances, and so for nodes
//
// COST: about 100 ns a polygon.
class SightCones3 {
 public:
  // REQUIRES: the planes outlive this.
  explicit SightCones3(const EyePlanes3& planes);

  const SightCone3& polygon(std::size_t s) const { return polygons_[s]; }
  const SightCone3& node(std::size_t n) const { return nodes_[n]; }

  // Sets `found` to the polygons that may hide something in the target. COST: logarithmic, and 10 ns for each found.
  void find_blockers(const SightCone3& target, std::vector<std::uint32_t>& found) const;

 private:
  const Blockers3& blockers_;
  std::vector<SightCone3> polygons_, nodes_;
  mutable std::vector<std::uint32_t> waiting_;
};

}  // namespace hottel
