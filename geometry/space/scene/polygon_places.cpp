#include "geometry/space/scene/polygon_places.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hottel {

Point3 moved(const Point3& p, const Rational& t, const Vector3& v) {
  return {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z};
}

Rational squared_distance(const Point3& a, const Point3& b) {
  const Vector3 way = a - b;
  return dot(way, way);
}

bool precedes(const Point3& a, const Point3& b) {
  if (const int order = cmp(a.x, b.x)) return order < 0;
  if (const int order = cmp(a.y, b.y)) return order < 0;
  return a.z < b.z;
}

ClosestPoint3 closest_point(const Side3& side, const Point3& p) {
  using Part = ClosestPoint3::Part;
  const Vector3 along = side.to - side.from, way = p - side.from;
  const Rational part = dot(along, way), whole = dot(along, along);
  if (part <= 0) return {side.from, dot(way, way), Part::kCorner};
  if (part >= whole) return {side.to, squared_distance(side.to, p), Part::kCorner};
  Point3 at = moved(side.from, part / whole, along);
  Rational squared = squared_distance(at, p);
  return {std::move(at), std::move(squared), Part::kSide};
}

ClosestPoint3 closest_point(const Polygon3& polygon, const Point3& p) {
  if (polygon.is_nearly_plane) {
    std::optional<ClosestPoint3> nearest;
    for (const Polygon3& facet : facets_of(polygon))
      if (ClosestPoint3 here = closest_point(facet, p); !nearest || here.squared < nearest->squared)
        nearest = std::move(here);
    return *nearest;
  }
  const Vector3 normal = doubled_area(polygon);
  const Rational above = dot(normal, p - polygon.points[0]), length = dot(normal, normal);
  Point3 foot = moved(p, -above / length, normal);
  if (contains_in_plane(polygon, normal, foot)) {
    std::optional<ClosestPoint3> on_border;
    for (const Side3& side : sides_of(polygon))
      if (ClosestPoint3 closest = closest_point(side, foot); closest.squared == 0) {
        if (!on_border || closest.part == ClosestPoint3::Part::kCorner) on_border = std::move(closest);
      }
    const auto part = on_border ? on_border->part : ClosestPoint3::Part::kInside;
    return {std::move(foot), above * above / length, part};
  }
  std::optional<ClosestPoint3> nearest;
  for (const Side3& side : sides_of(polygon))
    if (ClosestPoint3 closest = closest_point(side, p); !nearest || closest.squared < nearest->squared)
      nearest = std::move(closest);
  return *nearest;
}

std::optional<Side3> closest_insides(const Side3& a, const Side3& b) {
  const Vector3 u = a.to - a.from, v = b.to - b.from, way = b.from - a.from;
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  if (determinant == 0) return std::nullopt;
  const Rational uw = dot(u, way), vw = dot(v, way);
  const Rational s = (uw * vv - vw * uv) / determinant, t = (uw * uv - vw * uu) / determinant;
  if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return std::nullopt;
  return Side3{moved(a.from, s, u), moved(b.from, t, v)};
}

std::optional<Point3> meeting_point(const Polygon3& polygon, const Side3& segment) {
  if (polygon.is_nearly_plane) {
    for (const Polygon3& facet : facets_of(polygon))
      if (auto at = meeting_point(facet, segment)) return at;
    return std::nullopt;
  }
  const Vector3 normal = doubled_area(polygon);
  const Rational from = dot(normal, segment.from - polygon.points[0]), to = dot(normal, segment.to - polygon.points[0]);
  if (sgn(from) * sgn(to) > 0 || from == to) return std::nullopt;
  Point3 at = moved(segment.from, from / (from - to), segment.to - segment.from);
  if (!contains_in_plane(polygon, normal, at)) return std::nullopt;
  return at;
}

Rational squared_width(const Polygon3& polygon) {
  std::optional<Rational> least;
  for (const Side3& side : sides_of(polygon))
    for (const Point3& corner : corners_of(polygon)) {
      if (corner == side.from || corner == side.to) continue;
      Rational squared = closest_point(side, corner).squared;
      if (squared != 0 && (!least || squared < *least)) least = std::move(squared);
    }
  return least.value_or(0);
}

}  // namespace hottel
