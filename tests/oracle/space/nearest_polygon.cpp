#include "tests/oracle/space/nearest_polygon.h"

namespace hottel::oracle {

RayCaster::RayCaster(const std::vector<SpacePolygon>& polygons, const SpacePoint& eye) {
  for (std::size_t s = 0; s < polygons.size(); ++s) {
    const SpacePolygon& polygon = polygons[s];
    Target target{static_cast<int>(s), normal_of(polygon), dot(normal_of(polygon), polygon[0] - eye), {}};
    if (target.height == 0) continue;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      target.sides.push_back(cross(polygon[k] - eye, polygon[(k + 1) % polygon.size()] - eye));
    targets_.push_back(std::move(target));
  }
}

NearestPolygon RayCaster::operator()(const SpacePoint& direction) const {
  NearestPolygon result;
  mpq_class nearest;
  for (const Target& target : targets_) {
    const mpq_class slope = dot(target.normal, direction);
    if (sgn(slope) != sgn(target.height)) continue;  // parallel, or met behind the eye
    int positive = 0, negative = 0, zero = 0;
    for (const SpacePoint& side : target.sides) {
      const int sign = sgn(dot(side, direction));
      ++(sign > 0 ? positive : sign < 0 ? negative : zero);
      if (positive > 0 && negative > 0) break;
    }
    if (positive > 0 && negative > 0) continue;
    if (zero > 0) return {false};
    const mpq_class distance = target.height / slope;
    if (result.polygon >= 0 && distance == nearest) return {false};
    if (result.polygon < 0 || distance < nearest) {
      nearest = distance;
      result.polygon = target.number;
    }
  }
  return result;
}

}  // namespace hottel::oracle
