#include "tests/oracle/space/point_factor.h"

#include <algorithm>
#include <numbers>

namespace hottel::oracle {
namespace {

constexpr double kNoArea = 1e-13;  // of polygons of size 1: what rounding makes of those without an area

// The part of a cone, or of a polygon, of which `above` is positive; `above` is linear.
template <class Above>
void clip(const FlatPolygon& corners, const Above& above, FlatPolygon& result) {
  result.clear();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector &p = corners[k], &q = corners[(k + 1) % corners.size()];
    const double a = above(p), b = above(q);
    if (a >= 0) result.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) result.push_back((b / (b - a)) * p + (a / (a - b)) * q);
  }
}

// Lambert's formula: corners around the axis of the cone in the positive sense.
double lambert(const FlatPolygon& corners, const Vector& up) {
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector &p = corners[k], &q = corners[(k + 1) % corners.size()];
    const Vector m = cross(p, q);
    const double size = length(m);
    if (size > 0) sum += std::atan2(size, dot(p, q)) * dot(m, up) / size;
  }
  return sum / (2 * std::numbers::pi);
}

// Convex cones that have no common inner directions, from which other cones are taken away.
class Cones {
 public:
  explicit Cones(FlatPolygon first) { cones_.push_back(std::move(first)); }

  // `sides`: normals of the sides of a convex cone, inward.
  void take_away(const FlatPolygon& sides) {
    std::vector<FlatPolygon> left;
    for (FlatPolygon& cone : cones_) {
      FlatPolygon rest = std::move(cone), part;
      for (const Vector& side : sides) {
        clip(
            rest, [&](const Vector& w) { return -dot(side, w); }, part);
        if (part.size() > 2) left.push_back(part);
        clip(
            rest, [&](const Vector& w) { return dot(side, w); }, part);
        std::swap(rest, part);
        if (rest.size() < 3) break;
      }
    }
    cones_ = std::move(left);
  }

  const std::vector<FlatPolygon>& parts() const { return cones_; }

 private:
  std::vector<FlatPolygon> cones_;
};

FlatPolygon seen_from(const FlatPolygon& polygon, const Vector& x) {
  FlatPolygon cone;
  for (const Vector& p : polygon) {
    const Vector w = p - x;
    cone.push_back((1 / length(w)) * w);
  }
  return cone;
}

// The normals of the sides of a cone, inward: of corners around the axis in the positive sense, or the negative one.
FlatPolygon sides_of(const FlatPolygon& cone, bool is_negative) {
  FlatPolygon sides;
  for (std::size_t k = 0; k < cone.size(); ++k) {
    const Vector side = cross(cone[k], cone[(k + 1) % cone.size()]);
    sides.push_back(is_negative ? -1 * side : side);
  }
  return sides;
}

}  // namespace

FlatPolygon part_above(const FlatPolygon& polygon, const FlatPlane& plane) {
  FlatPolygon result;
  double highest = 0;
  for (const Vector& p : polygon) highest = std::max(highest, plane.height(p));
  if (highest < kNoArea) return result;
  const auto height = [&](const Vector& p) {
    const double h = plane.height(p);
    return std::fabs(h) < kNoArea ? 0 : h;
  };
  clip(polygon, height, result);
  if (result.size() < 3 || area(result) < kNoArea) result.clear();
  return result;
}

PointFactor::PointFactor(const FlatPair& pair) : from_(pair.i), to_(pair.j), target_(part_above(pair.j, from_)) {
  for (const FlatPolygon& polygon : pair.between) {
    FlatPolygon part = part_above(polygon, from_);
    if (!part.empty()) part = part_above(part, to_);
    if (part.empty()) continue;
    planes_.emplace_back(polygon);
    between_.push_back(std::move(part));
  }
}

double PointFactor::operator()(const Vector& x) const {
  if (target_.empty() || to_.height(x) <= 0) return 0;
  FlatPolygon cone = seen_from(target_, x);
  std::reverse(cone.begin(), cone.end());  // who faces a front looks against its normal
  Cones cones(std::move(cone));
  for (std::size_t k = 0; k < between_.size() && !cones.parts().empty(); ++k)
    cones.take_away(sides_of(seen_from(between_[k], x), planes_[k].height(x) > 0));
  double sum = 0;
  for (const FlatPolygon& part : cones.parts()) sum += lambert(part, from_.normal);
  return sum;
}

}  // namespace hottel::oracle
