#include "geometry/space/check/repaired_shapes.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hottel {
namespace {

constexpr unsigned long kMostDecimals = 60;  // of the parameters along the sides of a polygon
constexpr std::size_t kLongPlace = 120;      // characters of coordinates beyond which shorter ones are looked for
constexpr std::size_t kLongestPlace = 300;   // of coordinates typed to six digits where a plane meets an edge: 200

std::size_t length_of(const Point3& p) { return to_string(p.x).size() + to_string(p.y).size() + to_string(p.z).size(); }

// The nearest number with so many decimals.
Rational rounded_to(const Rational& t, unsigned long decimals) {
  Integer power, rounded;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, decimals);
  const Rational scaled = t * power + Rational(1, 2);
  mpz_fdiv_q(rounded.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational near(rounded, power);
  near.canonicalize();
  return near;
}

// At most a sixteenth.
bool is_hardly_farther(const Point3& p, const Point3& place, const ClosestPoint3& closest) {
  return squared_distance(p, place) * 256 <= closest.squared * 289;
}

Point3 farthest_from_first_side(const Polygon3& polygon) {
  const Point3& base = polygon.points[0];
  const Vector3 side = polygon.points[1] - base;
  const auto squared_area = [&](const Point3& p) {
    const Vector3 normal = cross(side, p - base);
    return dot(normal, normal);
  };
  return *std::max_element(polygon.points.begin(), polygon.points.end(),
                           [&](const Point3& a, const Point3& b) { return squared_area(a) < squared_area(b); });
}

}  // namespace

bool is_long(const Point3& p) { return length_of(p) > kLongPlace; }

bool is_too_long(const Point3& p) { return length_of(p) > kLongestPlace; }

Point3 short_point_near(const Side3& side, const Point3& p, const ClosestPoint3& closest) {
  const Vector3 along = side.to - side.from;
  const Rational t = dot(along, p - side.from) / dot(along, along);
  for (unsigned long decimals = 1; decimals <= kMostDecimals; ++decimals) {
    const Rational near = rounded_to(t, decimals);
    if (near <= 0 || near >= 1) continue;
    Point3 place = moved(side.from, near, along);
    if (is_hardly_farther(p, place, closest)) return place;
  }
  return closest.at;
}

Point3 short_point_near(const Polygon3& polygon, const Point3& p, const ClosestPoint3& closest) {
  const Point3& base = polygon.points[0];
  const Vector3 u = polygon.points[1] - base, v = farthest_from_first_side(polygon) - base, normal = cross(u, v);
  const Vector3 to = closest.at - base;
  const Rational squared = dot(normal, normal);
  const Rational s = dot(cross(to, v), normal) / squared, t = dot(cross(u, to), normal) / squared;
  for (unsigned long decimals = 1; decimals <= kMostDecimals; ++decimals) {
    Point3 place = moved(moved(base, rounded_to(s, decimals), u), rounded_to(t, decimals), v);
    if (is_hardly_farther(p, place, closest)) return place;
  }
  return closest.at;
}

std::vector<Point3> without_repetitions(const std::vector<Point3>& ring) {
  std::vector<Point3> result;
  for (const Point3& p : ring)
    if (result.empty() || !(result.back() == p)) result.push_back(p);
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

bool has_area(const Polygon3& polygon) { return polygon.points.size() > 2 && !doubled_area(polygon).is_zero(); }

std::vector<Polygon3> fan_of(const Polygon3& polygon) {
  const std::vector<Point3>& p = polygon.points;
  const std::size_t n = p.size();
  if (!polygon.holes.empty()) return {};
  const Vector3 normal = doubled_area(polygon);
  for (std::size_t first = 0; first < n; ++first) {
    std::vector<Polygon3> triangles;
    for (std::size_t k = 1; k + 1 < n; ++k) {
      Polygon3 triangle;
      triangle.points = {p[first], p[(first + k) % n], p[(first + k + 1) % n]};
      if (dot(doubled_area(triangle), normal) > 0) triangles.push_back(std::move(triangle));
    }
    if (triangles.size() + 2 == n) return triangles;
  }
  return {};
}

}  // namespace hottel
