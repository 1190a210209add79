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
// One for each thread: it keeps working memory. COST: linear in the corners of polygons.
class SightCones3 {
 public:
  // REQUIRES: the planes outlive this.
  explicit SightCones3(const EyePlanes3& planes);

  const SightCone3& polygon(std::size_t s) const { return polygons_[s]; }
  const SightCone3& node(std::size_t n) const { return nodes_[n]; }

  // False only where the cones of the two polygons have no common inner direction: each is held against the planes of
  // the other.
  bool may_overlap(std::size_t s, std::size_t t) const { return may_cross(s, t) && may_cross(t, s); }

  // Sets `found` to the polygons that may hide something in the target. COST: that of the nodes whose cones meet that
  // of the target.
  void find_blockers(const SightCone3& target, std::vector<std::uint32_t>& found);

 private:
  struct UnitNormal {
    double x, y, z;
  };
  // False only where the round cone of t is outside a plane of the cone of s.
  bool may_cross(std::size_t s, std::size_t t) const {
    const SightCone3& cone = polygons_[t];
    if (cone.is_wide()) return true;
    for (std::size_t k = first_[s]; k < first_[s + 1]; ++k)
      if (normals_[k].x * cone.x + normals_[k].y * cone.y + normals_[k].z * cone.z < -cone.sine - 1e-9) return false;
    return true;
  }
  void add_normals(const EyePlanes3& planes);

  const Blockers3& blockers_;
  std::vector<SightCone3> polygons_, nodes_;
  std::vector<std::size_t> first_{0};  // of the planes of a polygon in normals_
  std::vector<UnitNormal> normals_;    // inward; zero where doubles do not tell it well
  std::vector<std::uint32_t> waiting_;
};

}  // namespace hottel
