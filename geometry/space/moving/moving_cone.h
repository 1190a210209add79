// Convex cones of directions from a point that moves. Internal to geometry/space/exchange.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "geometry/space/between/joined_bodies.h"
#include "geometry/space/moving/moving_planes.h"

namespace hottel {

// As ConeFragment3: corners in order, the inside on the positive side of the plane of each.
using MovingFragment3 = std::vector<MovingCorner3>;

// Fragments in a row, whose memory is used again.
class MovingFragments3 {
 public:
  std::size_t size() const { return size_; }
  MovingFragment3& operator[](std::size_t k) { return kept_[k]; }
  const MovingFragment3& operator[](std::size_t k) const { return kept_[k]; }
  void clear() { size_ = 0; }
  void resize_down(std::size_t size) { size_ = size; }
  MovingFragment3& add() {
    if (size_ == kept_.size()) kept_.emplace_back();
    kept_[size_].clear();
    return kept_[size_++];
  }
  // Of a deque that is moved from, the library makes a new one.
  friend void swap(MovingFragments3& a, MovingFragments3& b) noexcept {
    a.kept_.swap(b.kept_);
    std::swap(a.size_, b.size_);
  }

 private:
  std::deque<MovingFragment3> kept_;
  std::size_t size_ = 0;
};

// Cuts fragments, and relies on every sign that what it answers rests on: the answer holds, and the corners stay those
// of the same planes, as long as these signs do.
class MovingCutter3 {
 public:
  explicit MovingCutter3(MovingPlanes3& planes) : planes_(planes) {}

  // What bounds the cone of a body or a solid, or the opposite cone.
  struct Cone {
    bool is_antipodal;
    std::vector<PlaneSide3> sides;
    std::vector<std::uint32_t> corners;  // it is the hull of these
  };
  void set_cone(std::uint32_t body, int facing, bool is_antipodal, Cone& cone) const;
  // Of a solid. REQUIRES: `facings` are those of its faces, and one at least is seen from outside.
  void set_cone(const PairGeometry3::Solid& solid, std::span<const signed char> facings, bool is_antipodal,
                Cone& cone) const;
  // Of joined bodies, and relies on its being one. False where it is none: `cone` is then any.
  bool set_cone(const JoinedBodies3::Group& group, bool is_antipodal, Cone& cone);
  // REQUIRES: it is the cone of one body.
  void set_fragment(const Cone& cone, int facing, MovingFragment3& fragment) const;

  enum class Cut : unsigned char { kNothing, kPart, kAll };
  // Takes away what is not on the positive side: says how much.
  Cut clip(MovingFragment3& fragment, PlaneSide3 side);

  // True iff the two have no common inner direction. `hint`: which plane told so last, which is tried first.
  bool is_apart(const MovingFragment3& fragment, const Cone& cone, std::uint32_t& hint);

  // Appends to `rest` what is left of the fragment when all that is on the positive side of every one of these is
  // taken away; returns whether anything was. The fragment is any afterwards.
  bool subtract(MovingFragment3& fragment, std::span<const PlaneSide3> sides, MovingFragments3& rest);

 private:
  struct Extremes {
    bool has_positive = false, has_negative = false;
  };
  bool separates(const MovingFragment3& fragment, const Cone& cone, std::uint32_t place);
  Extremes find_signs(const MovingFragment3& fragment, PlaneSide3 side);

  MovingPlanes3& planes_;
  std::vector<signed char> signs_;
  MovingFragment3 current_, next_;
};

}  // namespace hottel
