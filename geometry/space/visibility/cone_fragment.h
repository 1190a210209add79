// Convex cones of directions, cut by planes through the eye. Internal to geometry/space/visibility.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/eye_planes.h"

namespace hottel {

// A convex cone with inner points, less than a half space: its corners in order, the inside on the positive side of
// every corner's plane. The edge on the plane of a corner ends at the next corner, which is where its plane meets that
// of the next corner.
using ConeFragment3 = std::vector<ConeCorner3>;

// Fragments in a row, whose memory is used again.
class FragmentList3 {
 public:
  std::size_t size() const { return size_; }
  ConeFragment3& operator[](std::size_t k) { return kept_[k]; }
  void clear() { size_ = 0; }
  // Takes the last one away.
  void drop_last() { --size_; }
  // Appends a fragment without corners; it stays where it is when others are added.
  ConeFragment3& add() {
    if (size_ == kept_.size()) kept_.emplace_back();
    kept_[size_].clear();
    kept_[size_].reserve(8);
    return kept_[size_++];
  }

 private:
  std::deque<ConeFragment3> kept_;
  std::size_t size_ = 0;
};

// A convex cone by its bounds: where all sides are positive.
struct ConeBounds3 {
  std::span<const PlaneSide3> sides;
  std::span<const VertexId3> corners;  // the cone is that around the directions to these
  // Unit normals of the sides and a direction in the cone, in doubles, to guess by; zero where these do not tell them.
  std::span<const Direction3> inward;
  Direction3 axis;
};

// Sets `result` to the sides of planes that bound the cone of a polygon, in order. REQUIRES facing(s) != 0.
void cone_sides(const EyePlanes3& planes, std::size_t s, std::vector<PlaneSide3>& result);

// Sets `result` to the cone of a polygon. REQUIRES facing(s) != 0.
void cone_of_polygon(const EyePlanes3& planes, std::size_t s, ConeFragment3& result);

// Takes cones away from fragments. It keeps working memory: one for each thread.
class ConeCutter3 {
 public:
  explicit ConeCutter3(EyePlanes3& planes) : planes_(planes) {}

  // Sets `inside` to what is on the positive side; false where that has no inner point.
  bool clip(const ConeFragment3& fragment, PlaneSide3 side, ConeFragment3& inside);

  // True only where all of the fragment is in the cone, and then as a rule. `axis`: a direction in the fragment, to
  // guess by.
  bool is_inside(const ConeFragment3& fragment, const Direction3& axis, const ConeBounds3& cone);

  // True only where the fragment and the cone have no common inner direction, and then as a rule. On open sets: what
  // only touches is apart.
  bool is_apart(const ConeFragment3& fragment, const Direction3& axis, const ConeBounds3& cone);

  // Appends to `rest` what is left of the fragment when all that is on the positive side of every one of these is taken
  // away: the pieces are convex and have no common inner direction. False where that is all of it.
  bool subtract(const ConeFragment3& fragment, std::span<const PlaneSide3> sides, FragmentList3& rest);

 private:
  struct Extremes {
    bool has_positive = false, has_negative = false;
  };
  Extremes find_signs(const ConeFragment3& fragment, PlaneSide3 side);

  EyePlanes3& planes_;
  std::vector<signed char> signs_;  // of the corners at hand
  ConeFragment3 current_, next_;
};

}  // namespace hottel
