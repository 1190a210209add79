// The segments along which what points of one polygon see of another one may end.
#pragma once

#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

// A plane polygon among others, with its plane: normal . p = offset.
struct PlanePolygon {
  SpacePolygon points;
  SpacePoint normal;
  mpq_class offset;

  explicit PlanePolygon(SpacePolygon polygon)
      : points(std::move(polygon)), normal(normal_of(points)), offset(dot(normal, points[0])) {}
  mpq_class height(const SpacePoint& p) const { return dot(normal, p) - offset; }
  bool holds(const SpacePoint& a, const SpacePoint& b) const { return height(a) == 0 && height(b) == 0; }
  bool is_parallel(const PlanePolygon& other) const { return cross(normal, other.normal) == SpacePoint{0, 0, 0}; }
  bool is_coplanar(const PlanePolygon& other) const { return is_parallel(other) && height(other.points[0]) == 0; }
};

struct SpaceSegment {
  SpacePoint a, b;
};

bool are_collinear(const SpaceSegment& e, const SpaceSegment& f);

// Sides of polygons, in order.
std::vector<SpaceSegment> sides_of(const SpacePolygon& polygon);

// What the polygon has in common with the plane of another one: a segment, or nothing where they are parallel, or
// where only a point is common.
std::vector<SpaceSegment> common_with_plane(const SpacePolygon& polygon, const PlanePolygon& plane);

// What two polygons have in common: a segment, or nothing where they are parallel, or where only a point is common.
std::vector<SpaceSegment> common_segment(const PlanePolygon& a, const PlanePolygon& b);

// Seen from points of polygon 0, what is seen of polygon 1 ends at sides of polygons 1, 2, ..., where these pierce
// polygon 1, and where it dips below the plane of polygon 0. Each point of these in front of polygon 0, or in its plane
// and in that of polygon 1, is on one of the segments, and on one only.
std::vector<SpaceSegment> border_edges(const std::vector<PlanePolygon>& polygons);

}  // namespace hottel::oracle
