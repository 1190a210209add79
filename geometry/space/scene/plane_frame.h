// Planes of space, and points in them by two coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/space/point.h"
#include "geometry/space/scene/flat_region.h"

namespace hottel {

// A plane of space, with a side, and coordinates in it.
//
//   (1) two polygons have equal keys iff they lie in one plane: a x + b y + c z = d in coprime integers, the first of
//       a, b, c that is not 0 positive
//   (2) flat() leaves out the coordinate along which the normal (a, b, c) is not 0; what goes around counter-clockwise
//       seen from the side to which (a, b, c) points does so in (u, v). point() is its inverse
class PlaneFrame3 {
 public:
  using Key = std::array<Integer, 4>;

  // The plane of a polygon's first corner that is not straight. REQUIRES that not all its points lie on one line.
  explicit PlaneFrame3(const std::vector<Point3>& points);

  const Key& key() const { return key_; }
  bool precedes(const PlaneFrame3& other) const;  // an order by keys
  FlatPoint3 flat(const Point3& point) const;
  // The corners of an outline in this plane, counter-clockwise.
  std::vector<FlatPoint3> outline(const std::vector<Point3>& points) const;
  // Of a polygon of this plane: the outline, then the holes.
  FlatRegion3 region(const std::vector<Point3>& outline, const std::vector<std::vector<Point3>>& holes) const;
  Point3 point(const FlatPoint3& flat) const;
  // Where a point lies of the plane: + on the side of the normal; the distance times the length of the normal.
  Rational height(const Point3& point) const;
  // Whether a polygon of this plane has its front on the side of the normal: its points go around counter-clockwise.
  bool is_front_up(const std::vector<Point3>& points) const;

 private:
  Key key_;
  std::size_t dropped_ = 0, first_ = 1, second_ = 2;  // axes; u runs along `first_`
};

}  // namespace hottel
