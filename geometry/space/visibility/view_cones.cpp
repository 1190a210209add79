#include "geometry/space/visibility/view_cones.h"

#include <algorithm>
#include <cmath>

#include "kernel/doubles.h"

namespace hottel {
namespace {

constexpr double kLeastCosine = 0.1;  // of a cone that excludes anything: two of them stay below 180 degrees
constexpr double kSlack = 1e-12;      // far above the rounding of what is compared, relative to the distances
constexpr double kTurnSlack = 1e-14;  // far above the rounding of a cosine
// Relative error from which a direction is not used.
constexpr double kIllConditioned = 1e-12;

const ViewCone3 kEverywhere{1, 0, 0, -1, 0, 0, kInfinity};

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

// True for lengths whose squares neither underflow nor overflow.
bool is_plain(double value) { return value > 0x1p-400 && value < 0x1p400; }

// Sets the axis and the half angle, where the least cosine of the angle of a direction with it says that it is narrow.
void set_turn(ViewCone3& cone, const Direction3& axis, double least) {
  cone.x = axis.x;
  cone.y = axis.y;
  cone.z = axis.z;
  least -= kTurnSlack;
  if (least < kLeastCosine) return;
  cone.cosine = least;
  cone.sine = std::sqrt(1 - least * least);
}

// The distance of the plane of a polygon, or less; of a sun none is known.
double plane_distance(const EyePlanes3& planes, std::size_t s) {
  if (planes.eye().sun()) return 0;
  const BoundedVector& normal = planes.occluders().normal(s);
  const BoundedVector& toward = planes.eye().toward(planes.occluders().outline(s).front());
  const double product = normal.x * toward.x + normal.y * toward.y + normal.z * toward.z;
  return std::max(0.0, std::fabs(product) / length(normal.x, normal.y, normal.z) - kSlack * toward.size);
}

}  // namespace

double ViewBox3::distance() const {
  double square = 0;
  for (int a = 0; a < 3; ++a) {
    const double apart = std::max({low[a], -high[a], 0.0});
    square += apart * apart;
  }
  return std::sqrt(square) * (1 - kSlack);
}

ViewCones3::ViewCones3(const EyePlanes3& planes) : planes_(planes) {
  const std::size_t count = planes.occluders().vertices().size();
  sights_.reserve(count);
  for (std::size_t v = 0; v < count; ++v) {
    const BoundedVector& w = planes.eye().toward(VertexId3(v));
    const double distance = length(w.x, w.y, w.z);
    if (is_plain(distance))
      sights_.push_back({{w.x / distance, w.y / distance, w.z / distance}, distance});
    else
      sights_.push_back({{}, 0});
  }
}

ViewCone3 ViewCones3::around(const ViewBox3& box) {
  if (box.is_empty()) return {};
  const double x = (box.low[0] + box.high[0]) / 2, y = (box.low[1] + box.high[1]) / 2,
               z = (box.low[2] + box.high[2]) / 2;
  const double distance = length(x, y, z);
  const double radius =
      length(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]) / 2 + kSlack * distance;
  if (!is_plain(distance)) return kEverywhere;
  ViewCone3 cone{x / distance, y / distance, z / distance, -1, 0, 0, (distance + radius) * (1 + kSlack)};
  cone.nearest = box.distance();
  const double sine = radius / distance;
  if (sine * sine > 1 - kLeastCosine * kLeastCosine) return cone;
  cone.sine = sine;
  cone.cosine = std::sqrt(1 - sine * sine);
  return cone;
}

ViewCone3 ViewCones3::around(std::span<const std::uint32_t> polygons, std::span<const VertexId3> corners) const {
  ViewCone3 cone{1, 0, 0, -1, 0, kInfinity, 0};
  ViewBox3 box;
  Direction3 sum;
  for (const VertexId3 v : corners) {
    const Sight& sight = sights_[v.index()];
    if (sight.distance == 0) return kEverywhere;
    cone.farthest = std::max(cone.farthest, sight.distance);
    box.include(planes_.eye().toward(v));
    sum = sum + sight.direction;
  }
  cone.farthest *= 1 + kSlack;
  for (const std::uint32_t s : polygons) cone.nearest = std::min(cone.nearest, plane_distance(planes_, s));
  cone.nearest = std::max(cone.nearest, box.distance());
  const double size = hottel::length(sum);
  if (size < 1e-3) return cone;
  const Direction3 axis = (1 / size) * sum;
  double least = 1;
  for (const VertexId3 v : corners) least = std::min(least, dot(axis, sights_[v.index()].direction));
  set_turn(cone, axis, least);
  return cone;
}

ViewCone3 ViewCones3::around(const ConeFragment3& fragment) {
  ViewCone3 cone = kEverywhere;
  thread_local std::vector<Direction3> directions;
  directions.clear();
  Direction3 sum;
  bool is_good = true;
  for (const ConeCorner3& corner : fragment) {
    const BoundedVector& d = corner.direction;
    const double size = length(d.x, d.y, d.z);
    if (!is_plain(size)) return kEverywhere;
    is_good &= d.error <= kIllConditioned * size;
    directions.push_back((1 / size) * Direction3{d.x, d.y, d.z});
    sum = sum + directions.back();
  }
  const double size = hottel::length(sum);
  if (size < 1e-3) return cone;
  const Direction3 axis = (1 / size) * sum;
  double least = 1;
  for (const Direction3& direction : directions) least = std::min(least, dot(axis, direction));
  set_turn(cone, axis, is_good ? least : -1);
  return cone;
}

}  // namespace hottel
