// Where edges' moments are taken about. Internal to geometry/space/exchange.
#pragma once

#include <vector>

#include "geometry/space/between/pair_geometry.h"
#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/stretches/stretch.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// The point about which moments of edges are taken: the middle of the smaller patch; where each patch reaches the plane
// of the other one, a point of the line in which these planes meet, so that what is seen along that line counts
// nothing.
//
//   (1) exact: a point of the common line is on it
class MomentOrigin3 {
 public:
  // Moved by `shift` (see PairRequest3), for tests. REQUIRES: the bodies outlive this.
  MomentOrigin3(const PairGeometry3& bodies, const double (&shift)[3], long vertex_shift);

  const WeightedPoint3& point() const { return point_; }
  bool is_on_common_line() const { return is_on_common_line_; }

  // Where a stretch begins, from here, times both weights.
  IntegerVector way_to(const Stretch3& stretch) const;
  // That, `way_to`, times the way of the stretch, as a quotient.
  struct Moment {
    IntegerVector numerator;
    Integer denominator;
  };
  Moment moment_of(const Stretch3& stretch, const IntegerVector& way_to) const;
  Moment moment_of(const Stretch3& stretch) const { return moment_of(stretch, way_to(stretch)); }

 private:
  double extent(std::uint32_t patch) const;
  void set_in_the_middle();
  bool set_on_common_line(double shift);
  std::vector<WeightedPoint3> crossings(std::uint32_t patch) const;

  const PairGeometry3& bodies_;
  WeightedPoint3 point_;
  bool is_on_common_line_ = false;
};

// The direction of the sum of the unit normals of both patches, in doubles, long doubles, LongerReal or WideReal.
// REQUIRES: their planes meet in a line.
template <class Real>
ArcVector3<Real> direction_of_both_normals(const PairGeometry3& bodies);

}  // namespace hottel
