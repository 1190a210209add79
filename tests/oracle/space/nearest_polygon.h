// What a ray meets first, by brute force.
#pragma once

#include <vector>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

// The number of the polygon that a ray meets first, if any. Where the ray meets the boundary of a polygon, or two
// polygons in one point, it is not plain, and the polygon is not told.
struct NearestPolygon {
  static constexpr int kNoPolygon = -1;
  bool is_plain = true;
  int polygon = kNoPolygon;
};

// Follows rays from one eye, in rationals. A polygon whose plane contains the eye is left out.
class RayCaster {
 public:
  RayCaster(const std::vector<SpacePolygon>& polygons, const SpacePoint& eye);
  NearestPolygon operator()(const SpacePoint& direction) const;

 private:
  struct Target {
    int number;
    SpacePoint normal;
    mpq_class height;               // normal . (a point of the polygon - eye), not 0
    std::vector<SpacePoint> sides;  // inside the polygon: all side . direction > 0, or all < 0
  };
  std::vector<Target> targets_;
};

}  // namespace hottel::oracle
