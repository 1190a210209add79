// Boxes as lists of polygons, for tests of surfaces without a scene.
#pragma once

#include <vector>

#include "geometry/space/scene/polygon.h"

namespace hottel::box_faces {

using Points = std::vector<Point3>;

// Fronts outward: bottom, top, south, north, west, east.
inline std::vector<Points> box(const Point3& a, const Point3& b) {
  const auto at = [&](int x, int y, int z) {
    return Point3{x == 0 ? a.x : b.x, y == 0 ? a.y : b.y, z == 0 ? a.z : b.z};
  };
  return {{at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
          {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, {at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)},
          {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)}, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}};
}

inline std::vector<Points> operator+(std::vector<Points> a, const std::vector<Points>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::vector<Polygon3> polygons_of(const std::vector<Points>& lists) {
  std::vector<Polygon3> result;
  for (const Points& points : lists) result.push_back({points, {}});
  return result;
}

}  // namespace hottel::box_faces
