#include "viewer/edit/space/placing.h"

#include <array>
#include <cmath>
#include <utility>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"

namespace hottel {
namespace {

constexpr double kLeastSeen = 0.05;        // of an axis, as a part of its length: one that is seen from its end is none
constexpr double kMostTimesFarther = 1e6;  // than it was from the eye, that a place is dragged
constexpr double kLeastSlope = 0.1;        // of a plane to the rays of the eye, below which it is seen from its side

constexpr std::array<Direction3, 3> kAxes{Direction3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr std::array<Rational Vector3::*, 3> kParts{&Vector3::x, &Vector3::y, &Vector3::z};
constexpr std::array<Rational Point3::*, 3> kCoordinates{&Point3::x, &Point3::y, &Point3::z};

Rational dot_of(const Vector3& n, const Point3& p) { return n.x * p.x + n.y * p.y + n.z * p.z; }

// 1 long, whatever the length of the vector.
Direction3 unit_of(const Vector3& v) {
  const Rational size = std::max<Rational>({abs(v.x), abs(v.y), abs(v.z)});
  return unit({to_double(v.x / size), to_double(v.y / size), to_double(v.z / size)});
}

// The axis of x, y, z along which a vector is longest.
std::size_t longest_part(const Vector3& v) {
  const std::array<Rational, 3> size{abs(v.x), abs(v.y), abs(v.z)};
  return size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
}

Vector3 axis_vector(std::size_t axis) {
  Vector3 v;
  v.*kParts[axis] = 1;
  return v;
}

// The point of a line through `from` that is nearest to the ray of the mouse.
Direction3 nearest_on_line(const Direction3& from, const Direction3& along, const Pointer3& pointer) {
  const Direction3 ray = unit(pointer.way_to(pointer.at)), way = from - pointer.eye;
  const double c = dot(along, ray);
  return from + ((c * dot(ray, way) - dot(along, way)) / (1 - c * c)) * along;
}

Direction3 on_plane(const Direction3& from, const Direction3& normal, const Pointer3& pointer) {
  const Direction3 ray = unit(pointer.way_to(pointer.at));
  const double slope = dot(normal, ray);
  if (std::abs(slope) > kLeastSlope) {
    const double along = dot(normal, from - pointer.eye) / slope;
    if (along > 0) return pointer.eye + along * ray;
  }
  const Direction3 beside = place_beside(from, pointer);
  return beside - dot(normal, beside - from) * normal;
}

}  // namespace

int decimals_at_place(const Direction3& place, const Pointer3& pointer) {
  return decimals_at(1 / pointer.length_of_pixel(place)) + 1;
}

Point3 rounded_place(const Direction3& place, const Point3& other, int decimals) {
  const auto coordinate = [decimals](double value, const Rational& before) {
    const Rational change = exact_value(value) - before;
    return 2 * abs(change) < decimal_step(decimals) ? before : rounded_decimal(value, decimals);
  };
  return {coordinate(place.x, other.x), coordinate(place.y, other.y), coordinate(place.z, other.z)};
}

Direction3 place_beside(const Direction3& from, const Pointer3& pointer) {
  return pointer.eye + pointer.depth(from) * pointer.way_to(pointer.at);
}

std::optional<int> axis_seen_along(const Direction3& from, const Pointer3& pointer) {
  const Pixel at = pointer.seen(from);
  const double dx = pointer.at.x - at.x, dy = pointer.at.y - at.y;
  double most = 0;
  std::optional<int> result;
  for (int k = 0; k < 3; ++k) {
    const Direction3& axis = kAxes[static_cast<std::size_t>(k)];
    const double x = dot(axis, pointer.right) - at.x * dot(axis, pointer.forward);
    const double y = dot(axis, pointer.up) - at.y * dot(axis, pointer.forward);
    const double seen = std::hypot(x, y), same = std::abs(x * dx + y * dy) / seen;
    if (!(seen > kLeastSeen) || !(same > most)) continue;
    most = same;
    result = k;
  }
  return result;
}

Direction3 way_along_seen_axis(const Direction3& from, const Pointer3& pointer) {
  const std::optional<int> axis = axis_seen_along(from, pointer);
  return axis ? nearest_on_line(from, kAxes[static_cast<std::size_t>(*axis)], pointer) - from : Direction3{0, 0, 0};
}

bool is_within_reach_of_hands(const Direction3& from, const Direction3& to, const Pointer3& pointer) {
  return length(to - from) <= kMostTimesFarther * length(from - pointer.eye);
}

Plane3 plane_through(const Point3& point, const Vector3& normal) { return {normal, dot_of(normal, point)}; }

void Freedom3::hold_on_axis(int axis) {
  for (std::size_t k = 0; k < 3; ++k)
    if (k != static_cast<std::size_t>(axis)) hold(axis_vector(k));
}

bool Freedom3::take(const Plane3& plane) {
  HOTTEL_REQUIRE(!plane.normal.is_zero());
  const bool is_new = planes_.empty()       ? true
                      : planes_.size() == 1 ? !cross(planes_[0].normal, plane.normal).is_zero()
                      : planes_.size() == 2 ? dot(line(), plane.normal) != 0
                                            : false;
  if (is_new) planes_.push_back(plane);
  return is_new;
}

Direction3 Freedom3::at(const Pointer3& pointer) const {
  const Direction3 from = place_of(begin_);
  if (planes_.empty()) return place_beside(from, pointer);
  if (planes_.size() == 1) return on_plane(from, unit_of(planes_[0].normal), pointer);
  return planes_.size() == 2 ? nearest_on_line(from, unit_of(line()), pointer) : from;
}

// The point of two planes that are there, and a third one.
Point3 Freedom3::solved(const Plane3& third) const {
  const Plane3 &a = planes_[0], &b = planes_[1];
  const Vector3 bc = cross(b.normal, third.normal), ca = cross(third.normal, a.normal), ab = line();
  const Rational below = dot(ab, third.normal);
  Point3 p;
  for (std::size_t k = 0; k < 3; ++k)
    p.*kCoordinates[k] = (a.offset * bc.*kParts[k] + b.offset * ca.*kParts[k] + third.offset * ab.*kParts[k]) / below;
  return p;
}

Point3 Freedom3::rounded(const Direction3& place, int decimals) const {
  if (planes_.size() == 3) return solved(planes_[2]);
  Point3 p = rounded_place(place, begin_, decimals);
  if (planes_.empty()) return p;
  if (planes_.size() == 2) {
    const std::size_t k = longest_part(line());
    return solved({axis_vector(k), p.*kCoordinates[k]});
  }
  const auto& [normal, offset] = planes_[0];
  const std::size_t k = longest_part(normal);
  p.*kCoordinates[k] += (offset - dot_of(normal, p)) / normal.*kParts[k];
  return p;
}

Point3 Freedom3::onto(const Point3& point) const {
  if (planes_.size() == 3) return solved(planes_[2]);
  if (planes_.size() == 2) return solved(plane_through(point, line()));
  if (planes_.empty()) return point;
  const auto& [normal, offset] = planes_[0];
  const Rational t = (offset - dot_of(normal, point)) / dot(normal, normal);
  return {point.x + t * normal.x, point.y + t * normal.y, point.z + t * normal.z};
}

}  // namespace hottel
