// Middles of what findings in space speak of, and their words (geometry/scene_names.h).
#pragma once

#include <string>

#include "geometry/scene_names.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns the point half-way between the two, exactly; their order does not matter.
inline Point3 middle(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

// Returns the mean of the corners of a polygon, exactly: a point of it where it is convex.
inline Point3 middle(const Polygon3& polygon) {
  Point3 sum;
  for (const Point3& p : polygon.points) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  const Rational count(static_cast<unsigned long>(polygon.points.size()));
  return {sum.x / count, sum.y / count, sum.z / count};
}

}  // namespace hottel
