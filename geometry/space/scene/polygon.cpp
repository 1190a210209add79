#include "geometry/space/scene/polygon.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "kernel/decimal.h"

namespace hottel {
namespace {

constexpr std::array<Rational Vector3::*, 3> kAxes{&Vector3::x, &Vector3::y, &Vector3::z};

// As arithmetic leaves it; mpq_class(2, 4) is not.
bool is_in_lowest_terms(const Rational& value) {
  const Integer &p = value.get_num(), &q = value.get_den();
  return q == 1 || (q > 0 && gcd(p, q) == 1);
}

bool is_in_lowest_terms(const Point3& point) {
  return is_in_lowest_terms(point.x) && is_in_lowest_terms(point.y) && is_in_lowest_terms(point.z);
}

std::string text_of(const Point3& point) {
  return "(" + short_text(point.x) + ", " + short_text(point.y) + ", " + short_text(point.z) + ")";
}

const Point3* repeated_point(const std::vector<Point3>& points) {
  std::vector<const Point3*> order(points.size());
  std::transform(points.begin(), points.end(), order.begin(), [](const Point3& point) { return &point; });
  std::sort(order.begin(), order.end(), [](const Point3* a, const Point3* b) {
    if (const int c = cmp(a->x, b->x)) return c < 0;
    if (const int c = cmp(a->y, b->y)) return c < 0;
    return a->z < b->z;
  });
  const auto twice =
      std::adjacent_find(order.begin(), order.end(), [](const Point3* a, const Point3* b) { return *a == *b; });
  return twice == order.end() ? nullptr : *twice;
}

// The normal of the plane through the first two points and the next one that is not on their line.
std::optional<Vector3> normal_of_a_corner(const std::vector<Point3>& points) {
  const Vector3 first = points[1] - points[0];
  for (std::size_t k = 2; k < points.size(); ++k)
    if (Vector3 normal = cross(first, points[k] - points[0]); !normal.is_zero()) return normal;
  return std::nullopt;
}

// The largest distance from the plane through the first point, the one farthest from it, and the one farthest from the
// line of both.
std::string distance_off_a_plane(const std::vector<Point3>& points) {
  const Point3& origin = points[0];
  Vector3 far, normal;
  for (const Point3& point : points)
    if (const Vector3 way = point - origin; dot(way, way) > dot(far, far)) far = way;
  for (const Point3& point : points)
    if (const Vector3 way = cross(far, point - origin); dot(way, way) > dot(normal, normal)) normal = way;
  Rational most;
  for (const Point3& point : points) most = std::max(most, Rational(abs(dot(normal, point - origin))));
  return length_text(most * most / dot(normal, normal));
}

// What keeps a plane polygon from being convex. The axis is one along which its normal is not zero.
PolygonProblem3 convexity_problem(const Polygon3& polygon, Rational Vector3::*axis) {
  const char* const kHint = "in this version polygons are convex: divide it";
  const std::vector<Point3>& p = polygon.points;
  const std::size_t n = p.size();
  int side = sgn(doubled_area(polygon).*axis), changes = 0, first = 0, last = 0;
  const Rational Vector3::*along = axis == &Vector3::x ? &Vector3::y : &Vector3::x;
  for (std::size_t k = 0; k < n; ++k) {
    const Point3& corner = p[(k + 1) % n];
    const Vector3 in = corner - p[k], out = p[(k + 2) % n] - corner;
    const int turn = sgn(cross(in, out).*axis);
    if (turn == 0 && dot(in, out) < 0) return {"goes back along itself at the point " + text_of(corner), kHint};
    if (side == 0) side = turn;
    if (turn == -side && turn != 0)
      return {"is not convex: at the point " + text_of(corner) + " it turns the other way", kHint};
    const int sign = sgn(in.*along);
    if (sign == 0) continue;
    changes += last != 0 && sign != last;
    if (first == 0) first = sign;
    last = sign;
  }
  changes += last != first;
  return changes == 2 ? PolygonProblem3{} : PolygonProblem3{"goes around more than once: it crosses itself", kHint};
}

}  // namespace

PolygonProblem3 polygon_problem(const Polygon3& polygon) {
  const std::vector<Point3>& points = polygon.points;
  if (points.size() < 3) return {"has fewer than three points", ""};
  for (const Point3& point : points)
    if (!is_in_lowest_terms(point)) return {"has a coordinate that is not in lowest terms", "mpq_class::canonicalize"};
  if (const Point3* twice = repeated_point(points))
    return {"has the point " + text_of(*twice) + " twice", "the last point is joined to the first: do not repeat it"};
  const std::optional<Vector3> normal = normal_of_a_corner(points);
  if (!normal) return {"has no area: its points lie on one line", ""};
  if (points.size() == 3) return {};
  for (const Point3& point : points)
    if (dot(*normal, point - points[0]) != 0)
      return {"is not plane: points lie " + distance_off_a_plane(points) + " off the plane of three of them",
              "in this version polygons are exactly plane: divide it into triangles"};
  return convexity_problem(
      polygon, *std::find_if(kAxes.begin(), kAxes.end(), [&](const auto axis) { return (*normal).*axis != 0; }));
}

Vector3 doubled_area(const Polygon3& polygon) {
  Vector3 sum;
  for (std::size_t k = 2; k < polygon.points.size(); ++k) {
    const Vector3 part = cross(polygon.points[k - 1] - polygon.points[0], polygon.points[k] - polygon.points[0]);
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return sum;
}

}  // namespace hottel
