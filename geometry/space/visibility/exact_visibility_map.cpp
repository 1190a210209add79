#include "geometry/space/visibility/exact_visibility_map.h"

#include <algorithm>
#include <utility>

#include "geometry/space/predicates/eye.h"
#include "geometry/space/visibility/eye_planes.h"
#include "kernel/coprime_integers.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The normals that definitions of planes mean (PlaneDefinition3).
class PlaneNormals {
 public:
  PlaneNormals(const Occluders3& occluders, Eye3 eye) : occluders_(occluders), eye_(std::move(eye)) {}

  IntegerVector operator()(const PlaneDefinition3& plane) {
    HOTTEL_REQUIRE(plane.kind != PlaneDefinition3::Kind::kHorizon);
    if (plane.kind == PlaneDefinition3::Kind::kEdge)
      return primitive(cross(eye_.exact_toward(VertexId3(plane.a)), eye_.exact_toward(VertexId3(plane.b))));
    if (const SunFrame3* const sun = eye_.sun())
      return sun->crossing(plane_of(occluders_, plane.a), plane_of(occluders_, plane.b));
    // Polygon k is met at h_k / (N_k . w) > 0: at a before b where 0 < |h_b| |N_a . w| - |h_a| |N_b . w|.
    const Integer of_a = height(plane.a), of_b = height(plane.b);
    const IntegerVector m = primitive(
        difference(multiple(of_b, occluders_.exact_normal(plane.a)), multiple(of_a, occluders_.exact_normal(plane.b))));
    return sgn(of_a) == sgn(of_b) ? m : opposite(m);
  }

 private:
  Integer height(std::uint32_t s) {
    return dot(occluders_.exact_normal(s), eye_.exact_toward(occluders_.outline(s).front()));
  }

  const Occluders3& occluders_;
  Eye3 eye_;
};

ExactCone3 with_corners(std::vector<IntegerVector> inward) {
  ExactCone3 result{std::move(inward), {}};
  const std::size_t count = result.inward.size();
  result.corners.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    result.corners.push_back(primitive(cross(result.inward[(k + count - 1) % count], result.inward[k])));
  return result;
}

// The cone whose corners these ways are, in order, in either sense; some may be on the way between their neighbours.
ExactCone3 around(std::vector<IntegerVector> ways) {
  int sense = 0;
  for (std::size_t k = 2; k < ways.size() && sense == 0; ++k) sense = dot_sign(cross(ways[0], ways[1]), ways[k]);
  if (sense < 0) std::reverse(ways.begin(), ways.end());
  std::vector<IntegerVector> inward;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    IntegerVector side = primitive(cross(ways[k], ways[k + 1 == ways.size() ? 0 : k + 1]));
    if (inward.empty() || side != inward.back()) inward.push_back(std::move(side));
  }
  if (inward.size() > 1 && inward.front() == inward.back()) inward.pop_back();
  return with_corners(std::move(inward));
}

}  // namespace

ExactCone3::Located ExactCone3::locate(const IntegerVector& direction) const {
  Located result{Place::kInside, 0};
  std::size_t first = 0;
  for (std::size_t k = 0; k < inward.size(); ++k) {
    const int sign = dot_sign(inward[k], direction);
    if (sign < 0) return {};
    if (sign > 0) continue;
    if (result.place == Place::kInside) {
      result = {Place::kOnEdge, first = k};
    } else {
      result.place = Place::kAtCorner;
      // The corner is where the second of two neighbours begins.
      result.side = first == 0 && k + 1 == inward.size() ? 0 : k;
    }
  }
  return result;
}

std::optional<ExactCone3> common_cone(const ExactCone3& cone, const ExactCone3& other) {
  ExactCone3 current = cone, next;
  std::vector<int> signs;
  for (const IntegerVector& side : other.inward) {
    signs.clear();
    bool has_positive = false, has_negative = false;
    for (const IntegerVector& corner : current.corners) {
      signs.push_back(dot_sign(side, corner));
      has_positive |= signs.back() > 0;
      has_negative |= signs.back() < 0;
    }
    if (!has_positive) return std::nullopt;
    if (!has_negative) continue;
    next.inward.clear();
    next.corners.clear();
    const auto add = [&next](const IntegerVector& corner, const IntegerVector& inward) {
      next.corners.push_back(corner);
      next.inward.push_back(inward);
    };
    for (std::size_t k = 0; k < signs.size(); ++k) {
      const std::size_t after = k + 1 == signs.size() ? 0 : k + 1;
      const int here = signs[k], there = signs[after];
      if (here > 0 || (here == 0 && there > 0)) add(current.corners[k], current.inward[k]);
      if (here > 0 && there < 0) add(primitive(cross(current.inward[k], side)), side);
      if (here < 0 && there > 0) add(primitive(cross(side, current.inward[k])), current.inward[k]);
      if (here > 0 && there == 0) add(current.corners[after], side);
    }
    std::swap(current, next);
  }
  return current;
}

ExactVisibilityMap3::ExactVisibilityMap3(const Occluders3& occluders, const Point3& eye)
    : occluders_(occluders), eye_(eye), map_(map_from(occluders, {.eye = eye, .normal = {}})) {
  const Point3 p = occluders.vertices().from_scene(eye);
  denominator_ = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
  const auto numerator = [this](const Rational& value) -> Integer {
    return value.get_num() * (denominator_ / value.get_den());
  };
  numerator_ = {numerator(p.x), numerator(p.y), numerator(p.z)};

  make_cones(PlaneNormals(occluders, Eye3(occluders.vertices(), eye)));
}

ExactVisibilityMap3 ExactVisibilityMap3::of_sun(const Occluders3& occluders, const Vector3& direction) {
  ExactVisibilityMap3 result(occluders);
  result.sun_ = std::make_shared<const SunFrame3>(occluders.vertices(), direction);
  result.map_ = map_of_sun(occluders, direction);
  result.make_cones(PlaneNormals(occluders, Eye3::of_sun(occluders.vertices(), direction)));
  return result;
}

template <class NormalOf>
void ExactVisibilityMap3::make_cones(NormalOf normal_of) {
  std::vector<IntegerVector> normals;
  normals.reserve(map_.planes.size());
  for (const PlaneDefinition3& plane : map_.planes) normals.push_back(normal_of(plane));
  cones_.reserve(map_.fragments.size());
  for (const VisibilityMap3::Fragment& fragment : map_.fragments) {
    std::vector<IntegerVector> inward;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
      const PlaneSide3 side = map_.corners[c].side;
      const IntegerVector& normal = normals[side.plane.index()];
      inward.push_back(side.is_opposite ? opposite(normal) : normal);
    }
    cones_.push_back(with_corners(std::move(inward)));
  }
}

std::vector<Point3> ExactVisibilityMap3::corners_on_face(std::size_t fragment) const {
  const std::uint32_t s = map_.fragments[fragment].face.surface;
  const Vertices3& vertices = occluders_.vertices();
  const IntegerVector &normal = occluders_.exact_normal(s), &v = vertices.exact(occluders_.outline(s).front());
  if (sun_) {
    std::vector<Point3> places;
    for (const IntegerVector& corner : cones_[fragment].corners)
      places.push_back(sun_->meeting(corner, plane_of(occluders_, s)));
    return places;
  }
  // The way to the vertex, and so to the plane, in integer form times the denominator.
  const Integer height = dot(normal, difference(multiple(denominator_, v), numerator_));
  const Rational unit = vertices.scale() / denominator_;
  std::vector<Point3> result;
  for (const IntegerVector& corner : cones_[fragment].corners) {
    Rational t(height, dot(normal, corner));
    t.canonicalize();
    t *= unit;
    result.push_back({eye_.x + t * corner.x, eye_.y + t * corner.y, eye_.z + t * corner.z});
  }
  return result;
}

IntegerVector ExactVisibilityMap3::toward(const Point3& point) const {
  if (sun_) return sun_->toward(point);
  const Vector3 way = point - eye_;
  const auto [x, y, z] = coprime_integers<3>({way.x, way.y, way.z});
  return {x, y, z};
}

ExactCone3 ExactVisibilityMap3::cone_of(const Patch3& patch) const {
  std::vector<IntegerVector> ways;
  for (const IntegerVector& corner : patch.corners)
    ways.push_back(sun_ ? sun_->toward(corner, patch.weight)
                        : difference(multiple(denominator_, corner), multiple(patch.weight, numerator_)));
  return around(std::move(ways));
}

ExactCone3 ExactVisibilityMap3::cone_of(const std::vector<Point3>& corners) const {
  std::vector<IntegerVector> ways;
  for (const Point3& corner : corners) ways.push_back(toward(corner));
  return around(std::move(ways));
}

int ExactVisibilityMap3::nearness(const Point3& point, std::uint32_t polygon) const {
  const Vertices3& vertices = occluders_.vertices();
  const IntegerVector &normal = occluders_.exact_normal(polygon),
                      &v = vertices.exact(occluders_.outline(polygon).front());
  const Point3 p = vertices.from_scene(point);
  const int at_eye = sun_ ? sun_->facing(normal) : sgn(dot(normal, difference(numerator_, multiple(denominator_, v))));
  const Rational at_point = normal.x * (p.x - v.x) + normal.y * (p.y - v.y) + normal.z * (p.z - v.z);
  return sgn(at_point) * at_eye;
}

}  // namespace hottel
