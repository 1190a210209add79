#include "tests/oracle/space/filtered_rays.h"

#include <utility>

namespace hottel::oracle {
namespace {

RoughVector rough(const SpacePoint& p) { return {RoughNumber::of(p.x), RoughNumber::of(p.y), RoughNumber::of(p.z)}; }

RoughNumber size_of(const RoughNumber& x) { return {std::fabs(x.value), x.error}; }

}  // namespace

FilteredRayCaster::FilteredRayCaster(const std::vector<SpacePolygon>& polygons, const SpacePoint& eye)
    : polygons_(polygons), eye_(eye) {
  const RoughVector from = rough(eye);
  std::vector<RoughVector> corners;
  for (std::size_t s = 0; s < polygons.size(); ++s) {
    corners.clear();
    for (const SpacePoint& p : polygons[s]) corners.push_back(rough(p) - from);
    Target target{static_cast<int>(s), cross(corners[1] - corners[0], corners[2] - corners[0]), {}, 0, {}};
    target.height = dot(target.normal, corners[0]);
    if (target.height.sign() == 0) {  // as often as not the eye is in the plane
      const mpq_class height = dot(normal_of(polygons[s]), polygons[s][0] - eye);
      if (height == 0) continue;
      target.height = RoughNumber::of(height);
    }
    target.side = target.height.sign();
    for (std::size_t k = 0; k < corners.size(); ++k)
      target.sides.push_back(cross(corners[k], corners[(k + 1) % corners.size()]));
    targets_.push_back(std::move(target));
  }
}

FilteredRayCaster::Meets FilteredRayCaster::meets(const Target& target, const RoughVector& direction,
                                                  const RoughNumber& slope) {
  const int sign = slope.sign();
  if (sign * target.side < 0) return Meets::kNo;  // behind the eye
  int positive = 0, negative = 0, untold = sign == 0 || target.side == 0 ? 1 : 0;
  for (const RoughVector& side : target.sides) {
    const int of_side = dot(side, direction).sign();
    ++(of_side > 0 ? positive : of_side < 0 ? negative : untold);
    if (positive > 0 && negative > 0) return Meets::kNo;
  }
  return untold > 0 ? Meets::kMaybe : Meets::kYes;
}

std::optional<NearestPolygon> FilteredRayCaster::told(const RoughVector& direction) const {
  NearestPolygon result;
  RoughNumber height, slope;  // of the nearest, both positive: its distance is height / slope
  for (const Target& target : targets_) {
    const RoughNumber its_slope = dot(target.normal, direction);
    const Meets met = meets(target, direction, its_slope);
    if (met == Meets::kNo) continue;
    if (met == Meets::kMaybe) return std::nullopt;
    const RoughNumber h = size_of(target.height), s = size_of(its_slope);
    const int nearer = result.polygon < 0 ? 1 : (height * s - h * slope).sign();
    if (nearer == 0) return std::nullopt;
    if (nearer < 0) continue;
    height = h;
    slope = s;
    result.polygon = target.number;
  }
  return result;
}

NearestPolygon FilteredRayCaster::operator()(const SpacePoint& direction) {
  if (const std::optional<NearestPolygon> result = told(rough(direction))) return *result;
  ++undecided_;
  if (!exact_) exact_.emplace(polygons_, eye_);
  return (*exact_)(direction);
}

}  // namespace hottel::oracle
