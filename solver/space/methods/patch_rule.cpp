#include "solver/space/methods/patch_rule.h"

#include "kernel/exact_double.h"

namespace hottel {
namespace {

Vector3d place(const ElementPatch3& patch, const RulePoint3& point) {
  const Vector3d& first = patch.corners[point.corner[0]];
  Vector3d at = first;
  for (std::size_t k = 1; k < 4; ++k) at = at + point.share[k] * (patch.corners[point.corner[k]] - first);
  return at;
}

}  // namespace

std::vector<RulePoint3> rule_points(const ElementPatch3& patch, const GaussRule& rule) {
  std::vector<RulePoint3> points;
  const auto add = [&](RulePoint3 point, double weight) {
    point.share[0] = 1 - point.share[1] - point.share[2] - point.share[3];
    point.at = place(patch, point);
    point.weight = weight;
    points.push_back(point);
  };
  const auto& c = patch.corners;
  for (std::size_t k = 0; k < rule.place.size(); ++k)
    for (std::size_t l = 0; l < rule.place.size(); ++l) {
      const double s = rule.place[k], t = rule.place[l], weight = rule.weight[k] * rule.weight[l];
      if (c.size() == 4) {
        const Vector3d along = (1 - t) * (c[1] - c[0]) + t * (c[2] - c[3]);
        const Vector3d across = (1 - s) * (c[3] - c[0]) + s * (c[2] - c[1]);
        add({.corner = {0, 1, 2, 3}, .share = {0, s * (1 - t), s * t, (1 - s) * t}, .at = {}},
            weight * dot(cross(along, across), patch.normal) / patch.area);
        continue;
      }
      for (std::size_t m = 1; m + 1 < c.size(); ++m)
        add({.corner = {0, m, m + 1, 0}, .share = {0, s * (1 - t), s * t, 0}, .at = {}},
            weight * s * dot(cross(c[m] - c[0], c[m + 1] - c[0]), patch.normal) / patch.area);
    }
  return points;
}

Point3 exact_point(std::span<const Point3> corners, const RulePoint3& point) {
  const Point3& first = corners[point.corner[0]];
  Point3 result = first;
  for (std::size_t k = 1; k < 4; ++k) {
    if (point.share[k] == 0) continue;
    const Rational share = exact_value(point.share[k]);
    const Point3& corner = corners[point.corner[k]];
    result.x += share * (corner.x - first.x);
    result.y += share * (corner.y - first.y);
    result.z += share * (corner.z - first.z);
  }
  return result;
}

}  // namespace hottel
