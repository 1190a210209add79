// Convex cones of directions, cut by planes through the eye. Internal to geometry/space/visibility.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

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
  // Appends a fragment without corners; it stays where it is when others are added.
  ConeFragment3& add() {
    if (size_ == kept_.size()) kept_.emplace_back();
    kept_[size_].clear();
    return kept_[size_++];
  }

 private:
  std::deque<ConeFragment3> kept_;
  std::size_t size_ = 0;
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

  // True iff the fragment is on the positive side of all of these.
  bool is_inside(const ConeFragment3& fragment, std::span<const PlaneSide3> sides);

  // True iff the fragment and the cone of polygon s have no common inner direction; `sides` are those of that cone.
  // Exact, on open sets: what only touches is apart.
  bool is_apart(const ConeFragment3& fragment, std::size_t s, std::span<const PlaneSide3> sides);

  // Appends to `rest` what is left of the fragment when all that is on the positive side of every one of these is taken
  // away: the pieces are convex and have no common inner direction.
  void subtract(const ConeFragment3& fragment, std::span<const PlaneSide3> sides, FragmentList3& rest);

 private:
  struct Extremes {
    bool has_positive = false, has_negative = false;
  };
  Extremes find_signs(const ConeFragment3& fragment, PlaneSide3 side);
  void split(const ConeFragment3& fragment, PlaneSide3 side, ConeFragment3* inside, ConeFragment3* outside);

  EyePlanes3& planes_;
  std::vector<signed char> signs_;  // of the corners at hand
  ConeFragment3 current_, next_;
};

}  // namespace hottel
