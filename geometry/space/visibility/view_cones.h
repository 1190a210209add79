// Round cones around what an eye sees, to tell what cannot hide what. Internal to geometry/space/visibility.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/space/visibility/cone_fragment.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/eye_planes.h"
#include "kernel/doubles.h"

namespace hottel {

// A round cone at the eye and two distances, around a polygon or around many.
struct ViewCone3 {
  double x = 0, y = 0, z = 0;         // unit axis
  double cosine = -1, sine = 0;       // of the half angle; cosine -1: no direction is excluded
  double nearest = 0, farthest = -1;  // farthest -1: around nothing

  bool is_empty() const { return farthest < 0; }
  bool is_wide() const { return cosine < 0; }
  Direction3 axis() const { return {x, y, z}; }
};

// False only where the two have no common inner direction: for both by themselves, the rounding of all doubles
// included.
inline bool may_overlap(const ViewCone3& a, const ViewCone3& b) {
  if (a.is_wide() || b.is_wide()) return true;
  constexpr double kSlack = 1e-9;
  return a.x * b.x + a.y * b.y + a.z * b.z >= a.cosine * b.cosine - a.sine * b.sine - kSlack;
}

// False only where nothing in `occluder` can hide anything in `target`.
inline bool may_hide(const ViewCone3& occluder, const ViewCone3& target) {
  return occluder.nearest <= target.farthest && !occluder.is_empty() && may_overlap(occluder, target);
}

// An axis-parallel box of vectors from the eye.
struct ViewBox3 {
  double low[3] = {kInfinity, kInfinity, kInfinity}, high[3] = {-kInfinity, -kInfinity, -kInfinity};

  void include(const BoundedVector& w) {
    const double values[3] = {w.x, w.y, w.z};
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], values[a]);
      high[a] = std::max(high[a], values[a]);
    }
  }
  void include(const ViewBox3& other) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], other.low[a]);
      high[a] = std::max(high[a], other.high[a]);
    }
  }
  bool is_empty() const { return low[0] > high[0]; }
  // How far it is, at least.
  double distance() const;
};

// Makes round cones: all that they are around is within them and between their distances.
class ViewCones3 {
 public:
  // REQUIRES: the planes outlive this.
  explicit ViewCones3(const EyePlanes3& planes);

  // Around polygons that have these corners.
  ViewCone3 around(std::span<const std::uint32_t> polygons, std::span<const VertexId3> corners) const;
  static ViewCone3 around(const ViewBox3& box);
  // Around a fragment, without distances: 0 to infinity.
  static ViewCone3 around(const ConeFragment3& fragment);

 private:
  struct Sight {
    Direction3 direction;
    double distance;  // 0 where doubles do not tell the direction
  };

  const EyePlanes3& planes_;
  std::vector<Sight> sights_;  // of vertices
};

}  // namespace hottel
