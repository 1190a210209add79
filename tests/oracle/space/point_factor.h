// The view factor from points to a polygon behind others, by clipping cones in doubles.
#pragma once

#include <vector>

#include "tests/oracle/space/flat_polygon.h"

namespace hottel::oracle {

// What points of i see of j. All that is behind the plane of i or of j is cut off once; from a point the cone of what
// is left of j, less the cones of what is left between, is cut into convex parts, of which Lambert's formula gives the
// factors.
//
// Nothing is decided exactly: what touches leaves slivers of the size of rounding, which count as much.
// REQUIRES: points on i that are not in the plane of any polygon between.
// COST: a microsecond with three triangles between.
class PointFactor {
 public:
  explicit PointFactor(const FlatPair& pair);

  double operator()(const Vector& x) const;

  // What is left of j and of those between; nothing is left of j where no point of i sees it.
  const FlatPolygon& target() const { return target_; }
  const std::vector<FlatPolygon>& between() const { return between_; }

 private:
  FlatPlane from_, to_;
  FlatPolygon target_;
  std::vector<FlatPolygon> between_;
  std::vector<FlatPlane> planes_;  // of those
};

// The part of a polygon that is above a plane, or nothing where that has no area.
FlatPolygon part_above(const FlatPolygon& polygon, const FlatPlane& plane);

}  // namespace hottel::oracle
