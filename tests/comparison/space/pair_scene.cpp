#include "tests/comparison/space/pair_scene.h"

#include <algorithm>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "tests/comparison/space/map_comparison.h"

namespace hottel::oracle {

PairScene3::PairScene3(const std::vector<SpacePolygon>& polygons)
    : occluders_(engine_polygons(polygons)), measurer_(occluders_) {
  const double length = to_double(scaled_by_power_of_two(occluders_.vertices().scale(), occluders_.vertices().shift()));
  unit_ = length * length;
}

Patch3 PairScene3::patch(std::size_t s, bool is_back) const {
  Patch3 patch = whole_patch(occluders_, static_cast<std::uint32_t>(s));
  if (is_back) std::reverse(patch.corners.begin(), patch.corners.end());
  return patch;
}

std::vector<Patch3> PairScene3::quarters(std::size_t s) const {
  const std::vector<IntegerVector> p = patch(s).corners;
  const auto part = [s](std::vector<IntegerVector> corners) {
    return Patch3{static_cast<std::uint32_t>(s), std::move(corners), 2};
  };
  std::vector<Patch3> parts;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const IntegerVector &at = p[k], &next = p[(k + 1) % p.size()], &before = p[(k + p.size() - 1) % p.size()];
    std::vector<IntegerVector> corners{sum(at, at), sum(at, next), sum(before, at)};
    if (p.size() == 4) corners.insert(corners.begin() + 2, sum(at, p[(k + 2) % 4]));
    parts.push_back(part(std::move(corners)));
  }
  if (p.size() == 3) parts.push_back(part({sum(p[0], p[1]), sum(p[1], p[2]), sum(p[2], p[0])}));
  return parts;
}

std::vector<Patch3> PairScene3::sky(long margin) const {
  IntegerVector low = occluders_.vertices().exact(VertexId3(0)), high = low;
  for (std::size_t k = 0; k < occluders_.vertices().size(); ++k) {
    const IntegerVector& p = occluders_.vertices().exact(VertexId3(k));
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  low = {low.x - margin, low.y - margin, low.z - margin};
  high = {high.x + margin, high.y + margin, high.z + margin};
  const IntegerVector corner[8] = {{low.x, low.y, low.z},    {high.x, low.y, low.z}, {high.x, high.y, low.z},
                                   {low.x, high.y, low.z},   {low.x, low.y, high.z}, {high.x, low.y, high.z},
                                   {high.x, high.y, high.z}, {low.x, high.y, high.z}};
  const int sides[6][4] = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  std::vector<Patch3> result;
  for (const int(&side)[4] : sides) {
    result.emplace_back();
    for (const int k : side) result.back().corners.push_back(corner[k]);
  }
  return result;
}

PairResult3 PairScene3::measure(const Patch3& i, const Patch3& j, const PairRequest3& request) const {
  PairResult3 result = measurer_.measure(i, j, request);
  result.measure *= unit_;
  result.error *= unit_;
  result.bounds = {result.bounds.lower * unit_, result.bounds.upper * unit_};
  return result;
}

double PairScene3::unobstructed(const Patch3& i, const Patch3& j) const {
  return unit_ * unobstructed_measure(occluders_.vertices(), i, j, 1e-13).measure;
}

double PairScene3::area(const Patch3& i) const {
  const Enclosure area = patch_area(occluders_.vertices(), i);
  return unit_ * (area.lower + area.upper) / 2;
}

}  // namespace hottel::oracle
