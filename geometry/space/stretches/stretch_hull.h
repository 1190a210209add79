// What cannot hide anything between a stretch and a patch, in doubles. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/between/pair_geometry.h"
#include "geometry/space/stretches/stretch.h"
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
  explicit StretchHull3(const PairGeometry3& bodies);

  // Takes the part of a stretch from t = low to high, and a patch.
  void take(const Stretch3& stretch, double low, double high, std::uint32_t patch);
  // Of lines that come from the other patch: leaves out what is beyond the stretch for none of them.
  void take_lines_from(std::uint32_t patch);

  bool hides_nothing(std::uint32_t body) const;

 private:
  // A point, or, far away, a unit direction.
  struct Place {
    Direction3 at;
    bool is_far = false;
  };
  // Points of the hull have value >= 0.
  struct Plane {
    Direction3 normal;
    double offset;
    double value(const Place& p) const { return dot(normal, p.at) + (p.is_far ? 0 : offset); }
  };
  // Where all lines are beyond the stretch, on the side of this normal, if they are. They come from `nearest` at least.
  void add_beam_plane(const Direction3& normal, std::uint32_t from, double nearest);
  double least_distance(std::uint32_t patch) const;
  // Through three points, `c` not far.
  void add_plane(const Place& a, const Place& b, const Place& c);
  // What a value may be off.
  double slack_of(const Place& p) const { return p.is_far ? far_slack_ : slack_; }

  const PairGeometry3& bodies_;
  std::vector<Place> places_;  // of points
  double slack_ = 0, far_slack_ = 0;
  std::vector<Plane> planes_;
  std::vector<Place> hull_;  // the ends of the stretch, the corners of the patch
};

}  // namespace hottel
