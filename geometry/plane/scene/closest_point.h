// Distances of points, and the point of a segment that is nearest to another point.
#pragma once

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Returns |a - b|^2, exactly. [unit: the square of a scene length]
//
//   (1) the same for (b, a)
//   (2) 0 iff a == b
inline Rational squared_distance(const Point2& a, const Point2& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  return dx * dx + dy * dy;
}

// True iff both ends of an edge are on the line of another one.
inline bool is_on_line(const Edge2& line, const Edge2& edge) {
  return doubled_area(line.from, line.to, edge.from) == 0 && doubled_area(line.from, line.to, edge.to) == 0;
}

// Returns the position on the edge's line of the foot of the perpendicular from p: 0 at the first point, 1 at the
// second. Of a point on the line, point_at(edge, position_on(edge, p)) == p. REQUIRES: edge.from != edge.to.
inline Rational position_on(const Edge2& edge, const Point2& p) {
  const Rational dx = edge.to.x - edge.from.x, dy = edge.to.y - edge.from.y;
  return ((p.x - edge.from.x) * dx + (p.y - edge.from.y) * dy) / (dx * dx + dy * dy);
}

// The point of a segment that is nearest to a given point.
struct ClosestPoint2 {
  Point2 at;
  int end = -1;      // 0, 1: the first, second point of the segment; -1: inside
  Rational squared;  // distance
};

// Returns the point of the closed segment ab that is nearest to p: exact, without a root.
//
//   (1) squared == squared_distance(p, at), and no point of the segment is nearer to p
//   (2) end is 0 iff at == a, 1 iff at == b, else -1: `at` then is the foot of the perpendicular from p
//   (3) p == at and squared == 0 iff p lies on the segment
//
// REQUIRES: a != b.
// COST: about ten operations on rationals, and a division where the foot is inside.
inline ClosestPoint2 closest_point(const Point2& a, const Point2& b, const Point2& p) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const Rational along = dx * (p.x - a.x) + dy * (p.y - a.y), whole = dx * dx + dy * dy;
  ClosestPoint2 closest{a, 0, 0};
  if (along >= whole) {
    closest = {b, 1, 0};
  } else if (along > 0) {
    const Rational t = along / whole;
    closest = {{a.x + t * dx, a.y + t * dy}, -1, 0};
  }
  closest.squared = squared_distance(p, closest.at);
  return closest;
}

}  // namespace hottel
