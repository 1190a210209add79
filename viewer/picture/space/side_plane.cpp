#include "viewer/picture/space/side_plane.h"

#include <cmath>

#include "kernel/exact_double.h"
#include "viewer/picture/space/projection.h"

namespace hottel {
namespace {

constexpr double kFine = 0x1p30;  // places are multiples of 1 / kFine

Direction3 rounded_vector(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }

Rational fine(double place) { return exact_value(std::round(place * kFine)) / exact_value(kFine); }

}  // namespace

SidePlane3::SidePlane3(const PreparedScene3& prepared, const Face& side, const Point3& eye) {
  const std::vector<Point3>& outline = prepared.arrangement().pieces()[side.surface].polygon.points;
  origin_ = outline[0];
  a_ = outline[1] - origin_;
  for (std::size_t k = 2; k < outline.size() && (k == 2 || cross(a_, b_).is_zero()); ++k) b_ = outline[k] - origin_;
  const Direction3 a = rounded_vector(a_), b = rounded_vector(b_), n = cross(a, b);
  normal_ = (side.is_back ? -1 : 1) * unit(n);
  dual_a_ = (1 / dot(n, n)) * cross(b, n);
  dual_b_ = (1 / dot(n, n)) * cross(n, a);
  to_origin_ = rounded_way(eye, origin_);
}

Direction3 SidePlane3::way(const Direction3& direction) const {
  return (dot(to_origin_, normal_) / dot(direction, normal_)) * direction;
}

Point3 SidePlane3::point(const Direction3& way) const {
  const Direction3 from_origin = way - to_origin_;
  const Rational s = fine(dot(from_origin, dual_a_)), t = fine(dot(from_origin, dual_b_));
  return {origin_.x + s * a_.x + t * b_.x, origin_.y + s * a_.y + t * b_.y, origin_.z + s * a_.z + t * b_.z};
}

}  // namespace hottel
