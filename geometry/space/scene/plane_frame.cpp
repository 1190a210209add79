#include "geometry/space/scene/plane_frame.h"

#include <algorithm>
#include <utility>

#include "kernel/coprime_integers.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::array<Rational Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};

}  // namespace

PlaneFrame3::PlaneFrame3(const std::vector<Point3>& points) {
  Vector3 normal;
  for (std::size_t k = 2; k < points.size() && normal.is_zero(); ++k)
    normal = cross(points[1] - points[0], points[k] - points[0]);
  HOTTEL_REQUIRE(!normal.is_zero());
  const Point3& at = points[0];
  key_ = coprime_integers<4>({normal.x, normal.y, normal.z, normal.x * at.x + normal.y * at.y + normal.z * at.z});
  while (key_[dropped_] == 0) ++dropped_;
  if (key_[dropped_] < 0)
    for (Integer& value : key_) value = -value;
  first_ = (dropped_ + 1) % 3;
  second_ = (dropped_ + 2) % 3;
}

FlatRegion3 PlaneFrame3::region(const std::vector<Point3>& outline,
                                const std::vector<std::vector<Point3>>& holes) const {
  std::vector<std::vector<FlatPoint3>> loops;
  const auto add = [&](const std::vector<Point3>& points) {
    auto& loop = loops.emplace_back();
    for (const Point3& point : points) loop.push_back(flat(point));
  };
  add(outline);
  for (const auto& hole : holes) add(hole);
  return FlatRegion3(std::move(loops));
}

FlatPoint3 PlaneFrame3::flat(const Point3& point) const { return {point.*kAxes[first_], point.*kAxes[second_]}; }

Point3 PlaneFrame3::point(const FlatPoint3& flat) const {
  Point3 result;
  result.*kAxes[first_] = flat.u;
  result.*kAxes[second_] = flat.v;
  result.*kAxes[dropped_] = (key_[3] - key_[first_] * flat.u - key_[second_] * flat.v) / Rational(key_[dropped_]);
  return result;
}

Rational PlaneFrame3::height(const Point3& point) const {
  return key_[0] * point.x + key_[1] * point.y + key_[2] * point.z - key_[3];
}

std::vector<FlatPoint3> PlaneFrame3::outline(const std::vector<Point3>& points) const {
  std::vector<FlatPoint3> result;
  for (const Point3& point : points) result.push_back(flat(point));
  if (doubled_area(result) < 0) std::reverse(result.begin(), result.end());
  return result;
}

bool PlaneFrame3::is_front_up(const std::vector<Point3>& points) const {
  std::vector<FlatPoint3> loop;
  for (const Point3& point : points) loop.push_back(flat(point));
  return doubled_area(loop) > 0;
}

bool PlaneFrame3::precedes(const PlaneFrame3& other) const {
  for (std::size_t k = 0; k < key_.size(); ++k)
    if (const int order = cmp(key_[k], other.key_[k])) return order < 0;
  return false;
}

}  // namespace hottel
