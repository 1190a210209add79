#include "tests/oracle/space/free_ways.h"

#include <algorithm>
#include <cmath>

namespace hottel::oracle {
namespace {

// Longest component 1.
template <class Real>
VectorOf<Real> scaled(const VectorOf<Real>& a) {
  using std::fabs;
  const Real most = std::max({Real(fabs(a.x)), Real(fabs(a.y)), Real(fabs(a.z))});
  return Real(1 / most) * a;
}

template <class Real>
RoundedPolygon<Real> rounded(const std::vector<PlanePolygon>& all, std::size_t k, const SpaceSegment& f) {
  const PlanePolygon& polygon = all[k];
  const bool is_f_level = all[0].holds(f.a, f.b);
  RoundedPolygon<Real> result;
  for (const SpaceSegment& side : sides_of(polygon.points)) {
    result.points.push_back(vector_of<Real>(side.a));
    const bool is_level = is_f_level && all[0].holds(side.a, side.b);
    result.is_side_on_f.push_back(are_collinear(side, f) || is_level ? 1 : 0);
  }
  result.normal = scaled(vector_of<Real>(polygon.normal));
  result.holds_f = polygon.holds(f.a, f.b);
  result.is_level = polygon.is_coplanar(all[0]);
  result.is_parallel = polygon.is_parallel(all[0]);
  result.is_with_target = polygon.is_coplanar(all[1]);
  return result;
}

}  // namespace

template <class Real>
FreeWays<Real>::FreeWays(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f, Real least)
    : f_(scaled(vector_of<Real>(f.b - f.a))), is_f_level_(polygons[0].holds(f.a, f.b)), least_(least) {
  for (std::size_t k = 0; k < polygons.size(); ++k) polygons_.push_back(rounded<Real>(polygons, k, f));
}

template <class Real>
int FreeWays<Real>::sign(const Real& value) const {
  using std::fabs;
  if (!(fabs(value) > least_)) is_in_doubt_ = true;
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// Does the line of the way go through the polygon, which it meets from this side: 1 the front?
template <class Real>
bool FreeWays<Real>::passes(const RoundedPolygon<Real>& polygon, const Way& way, int side) const {
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const VectorOf<Real> normal = cross(polygon.points[k] - way.x, polygon.points[(k + 1) % n] - way.x);
    if (sign(dot(polygon.is_side_on_f[k] ? way.aside : way.w, normal)) == side) return false;
  }
  return true;
}

// Is it met after x and before polygon 1?
template <class Real>
bool FreeWays<Real>::is_before(const RoundedPolygon<Real>& polygon, const Way& way) const {
  if (polygon.is_level || polygon.is_with_target || (polygon.is_parallel && is_f_level_)) return false;
  const RoundedPolygon<Real>& target = polygons_[1];
  const Real height = dot(polygon.normal, polygon.points[0] - way.x), fall = dot(polygon.normal, way.w);
  const int side = -sign(fall);
  if (sign(height) == side || !passes(polygon, way, side)) return false;
  const Real there = dot(target.normal, target.points[0] - way.x), towards = dot(target.normal, way.w);
  if (polygon.holds_f && target.holds_f)
    return sign(dot(polygon.normal, way.aside) / fall - dot(target.normal, way.aside) / towards) > 0;
  return sign(there / towards - height / fall) > 0;
}

template <class Real>
bool FreeWays<Real>::is_free(const Way& way) const {
  if (is_f_level_ && sign(dot(polygons_[0].normal, way.aside)) < 0) return false;
  const RoundedPolygon<Real>& target = polygons_[1];
  if (sign(dot(target.normal, way.w)) > 0 || sign(dot(target.normal, target.points[0] - way.x)) > 0) return false;
  if (!passes(target, way, 1)) return false;
  return std::none_of(polygons_.begin() + 2, polygons_.end(),
                      [&](const RoundedPolygon<Real>& polygon) { return is_before(polygon, way); });
}

template <class Real>
std::optional<int> FreeWays<Real>::sides(const VectorOf<Real>& x, const VectorOf<Real>& q) const {
  is_in_doubt_ = false;
  const VectorOf<Real> w = scaled(q - x), aside = scaled(cross(w, f_));
  const int result = (is_free({x, w, aside}) ? 1 : 0) - (is_free({x, w, Real(-1) * aside}) ? 1 : 0);
  if (is_in_doubt_) return std::nullopt;
  return result;
}

template class FreeWays<double>;
template class FreeWays<RealOf<70>>;
template class FreeWays<RealOf<150>>;

}  // namespace hottel::oracle
