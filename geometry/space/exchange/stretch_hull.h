// What cannot hide anything between a stretch and a patch, in doubles. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/exchange/pair_bodies.h"
#include "geometry/space/exchange/stretch.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// The bodies of a pair in doubles, and the common hull of a part of a line and one of the patches.
//
//   (1) hides_nothing() is true only where the body is outside of the hull of the stretch and the patch, or both are on
//       one side of it, by far more than doubles lose: then no line between the two meets it
//
// For one thread. COST: a third of a microsecond for take(), some 30 ns a body.
class StretchHull3 {
 public:
  // REQUIRES: the bodies outlive this.
  explicit StretchHull3(const PairBodies3& bodies);

  // Takes the part of a stretch from t = low to high, and a patch.
  void take(const Stretch3& stretch, double low, double high, std::uint32_t patch);

  bool hides_nothing(std::uint32_t body) const;

 private:
  // Points of the hull have value >= 0.
  struct Plane {
    Direction3 normal;
    double offset;
  };
  void add_plane(const Direction3& a, const Direction3& b, const Direction3& c);

  const PairBodies3& bodies_;
  std::vector<Direction3> places_;  // of points, from the first one
  double slack_ = 0;
  std::vector<Plane> planes_;
  std::vector<Direction3> hull_;  // the ends of the stretch, the corners of the patch
};

}  // namespace hottel
