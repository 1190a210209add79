#include "geometry/space/check/repaired_shapes.h"

#include <cstddef>
#include <utility>

namespace hottel {
namespace {

constexpr unsigned long kMostDecimals = 60;  // of the parameter along an edge
constexpr std::size_t kLongPlace = 240;      // characters of coordinates beyond which shorter ones are looked for

}  // namespace

bool is_long(const Point3& p) {
  return to_string(p.x).size() + to_string(p.y).size() + to_string(p.z).size() > kLongPlace;
}

Point3 short_point_near(const Side3& side, const Point3& p, const ClosestPoint3& closest) {
  const Vector3 along = side.to - side.from;
  const Rational t = dot(along, p - side.from) / dot(along, along);
  Integer power = 1;
  for (unsigned long decimals = 1; decimals <= kMostDecimals; ++decimals) {
    power *= 10;
    Integer rounded;
    const Rational scaled = t * power + Rational(1, 2);
    mpz_fdiv_q(rounded.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    Rational near(rounded, power);
    near.canonicalize();
    if (near <= 0 || near >= 1) continue;
    Point3 place = moved(side.from, near, along);
    if (squared_distance(p, place) * 256 <= closest.squared * 289) return place;
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
