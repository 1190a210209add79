#include "geometry/space/scene/polygon.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "geometry/number.h"
#include "geometry/space/scene/bent_loops.h"
#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "kernel/decimal.h"

namespace hottel {
namespace {

constexpr std::array<Rational Vector3::*, 3> kVectorAxes{&Vector3::x, &Vector3::y, &Vector3::z};

bool has_lowest_terms(const Point3& point) {
  return is_in_lowest_terms(point.x) && is_in_lowest_terms(point.y) && is_in_lowest_terms(point.z);
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

// How a plane loop goes around. The axis is one along which its normal is not zero.
struct Turning {
  bool is_convex = false;
  const Point3* back_at = nullptr;  // there it goes back along itself
};

Turning turning_of(const std::vector<Point3>& p, Rational Vector3::*axis) {
  const std::size_t n = p.size();
  int side = 0, changes = 0, first = 0, last = 0;
  bool is_one_way = true;
  const Rational Vector3::*along = axis == &Vector3::x ? &Vector3::y : &Vector3::x;
  for (std::size_t k = 0; k < n; ++k) {
    const Point3& corner = p[(k + 1) % n];
    const Vector3 in = corner - p[k], out = p[(k + 2) % n] - corner;
    const int turn = sgn(cross(in, out).*axis);
    if (turn == 0 && dot(in, out) < 0) return {false, &corner};
    if (side == 0) side = turn;
    is_one_way &= turn == 0 || turn == side;
    const int sign = sgn(in.*along);
    if (sign == 0) continue;
    changes += last != 0 && sign != last;
    if (first == 0) first = sign;
    last = sign;
  }
  changes += last != first;
  return {is_one_way && changes == 2, nullptr};
}

Rational Vector3::*axis_of(const Vector3& normal) {
  return *std::find_if(kVectorAxes.begin(), kVectorAxes.end(), [&](const auto axis) { return normal.*axis != 0; });
}

// Outline and holes that are loops of one plane by themselves, together.
PolygonProblem3 problem_together(const Polygon3& polygon) {
  const PlaneFrame3 frame(polygon.points);
  const FlatRegion3 region = frame.region(polygon.points, polygon.holes);
  std::vector<PlaneTriangulation3::Segment> sides;
  region.append_sides(sides);
  const PlaneTriangulation3 triangulation(sides);
  if (triangulation.points().size() > triangulation.given_points())
    return {
        "crosses itself at the point " + place_text(frame.point(triangulation.points()[triangulation.given_points()])),
        "its sides, and those of its holes, may touch, but not cross"};
  // Twice the area inside, and that of the outline less the holes': equal where holes are in it, beside each other.
  Rational inside, told;
  for (std::uint32_t k = 0; k < triangulation.triangles().size(); ++k)
    if (region.contains(triangulation.centre(k))) inside += triangulation.doubled_area_of(k);
  for (std::size_t k = 0; k < region.loops().size(); ++k) {
    const Rational area = abs(doubled_area(region.loops()[k]));
    told += k == 0 ? area : Rational(-area);
  }
  if (inside == told && inside > 0) return {};
  if (polygon.holes.empty()) return {"goes around more than once: it crosses itself", ""};
  return {"has holes that are not in it, or share an area", "holes lie within the outline, beside each other"};
}

}  // namespace

PolygonProblem3 polygon_problem(const Polygon3& polygon) {
  const std::vector<Point3>& points = polygon.points;
  std::vector<const std::vector<Point3>*> loops{&points};
  for (const auto& hole : polygon.holes) loops.push_back(&hole);
  for (const auto* loop : loops) {
    const std::string of_hole = loop == &points ? "" : "a hole that ";
    if (loop->size() < 3) return {"has " + of_hole + (of_hole.empty() ? "" : "has ") + "fewer than three points", ""};
    for (const Point3& point : *loop)
      if (!has_lowest_terms(point)) return {"has a coordinate that is not in lowest terms", "mpq_class::canonicalize"};
    if (const Point3* twice = repeated_point(*loop))
      return {"has the point " + place_text(*twice) + " twice",
              loop->front() == loop->back() && *twice == loop->front()
                  ? "the last point is joined to the first: do not repeat it"
                  : "an outline passes each point once; a hole is a loop of its own"};
    if (!normal_of_a_corner(*loop))
      return {of_hole.empty() ? "has no area: its points lie on one line"
                              : "has a hole without an area: its points lie on one line",
              ""};
  }
  const Vector3 normal = *normal_of_a_corner(points);
  if (points.size() == 3 && polygon.holes.empty()) return {};
  if (polygon.is_nearly_plane) {
    if (!triangles_of_loops(loops_of(polygon)).empty()) return {};
    return {"is not plane, and cannot be cut into triangles: it crosses or touches itself, or a hole", ""};
  }
  for (const auto* loop : loops)
    for (const Point3& point : *loop)
      if (dot(normal, point - points[0]) != 0)
        return {
            "is not plane: points lie " + length_text(bend_of(corners_of(polygon)).squared_distance) +
                " off the plane of three of them",
            "this is more than rounding to the digits of the file makes: divide it into triangles, or have them made "
            "by --triangulate"};
  bool are_convex = true;
  for (const auto* loop : loops) {
    const Turning turning = turning_of(*loop, axis_of(normal));
    if (turning.back_at != nullptr)
      return {"goes back along itself at the point " + place_text(*turning.back_at), "leave that point out"};
    are_convex &= turning.is_convex;
  }
  return are_convex && polygon.holes.empty() ? PolygonProblem3{} : problem_together(polygon);
}

bool is_convex(const Polygon3& polygon) {
  return !polygon.is_nearly_plane && polygon.holes.empty() &&
         (polygon.points.size() == 3 || turning_of(polygon.points, axis_of(doubled_area(polygon))).is_convex);
}

std::string place_text(const Point3& point) {
  return "(" + short_text(point.x) + ", " + short_text(point.y) + ", " + short_text(point.z) + ")";
}

std::vector<Side3> sides_of(const Polygon3& polygon) {
  std::vector<Side3> sides;
  const auto add = [&](const std::vector<Point3>& ring, bool is_reversed) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point3 &from = ring[k], &to = ring[(k + 1) % ring.size()];
      sides.push_back(is_reversed ? Side3{to, from} : Side3{from, to});
    }
  };
  add(polygon.points, false);
  if (polygon.holes.empty()) return sides;
  const Vector3 normal = doubled_area(polygon);
  for (const std::vector<Point3>& hole : polygon.holes) add(hole, dot(normal, doubled_loop_area(hole)) > 0);
  return sides;
}

std::vector<Point3> corners_of(const Polygon3& polygon) {
  std::vector<Point3> points = polygon.points;
  for (const std::vector<Point3>& hole : polygon.holes) points.insert(points.end(), hole.begin(), hole.end());
  return points;
}

std::vector<std::vector<Point3>> loops_of(const Polygon3& polygon) {
  std::vector<std::vector<Point3>> loops{polygon.points};
  loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
  return loops;
}

std::vector<Polygon3> facets_of(const Polygon3& polygon) {
  if (!polygon.is_nearly_plane) return {polygon};
  if (!polygon.facets.empty()) {
    std::vector<Polygon3> own;
    for (const auto& [a, b, c] : polygon.facets) own.push_back({{a, b, c}});
    return own;
  }
  const std::vector<Point3> points = corners_of(polygon);
  std::vector<Polygon3> facets;
  for (const auto& [a, b, c] : triangles_of_loops(loops_of(polygon)))
    facets.push_back({{points[a], points[b], points[c]}});
  return facets;
}

bool contains(const Polygon3& polygon, const Point3& point) {
  if (polygon.is_nearly_plane) {
    const std::vector<Polygon3> facets = facets_of(polygon);
    return std::any_of(facets.begin(), facets.end(), [&](const Polygon3& facet) { return contains(facet, point); });
  }
  const Vector3 normal = doubled_area(polygon);
  return dot(normal, point - polygon.points[0]) == 0 && contains_in_plane(polygon, normal, point);
}

bool contains_in_plane(const Polygon3& polygon, const Vector3& normal, const Point3& p) {
  // Without the coordinate along which the normal is not 0: u and v are left.
  const bool drops_x = normal.x != 0, drops_y = !drops_x && normal.y != 0;
  const auto u = [&](const Point3& q) -> const Rational& { return drops_x ? q.y : q.x; };
  const auto v = [&](const Point3& q) -> const Rational& { return drops_x || drops_y ? q.z : q.y; };
  // Whether p lies on the side; if not, whether the side is one more that is passed on the way out.
  bool is_inside = false;
  const auto is_on = [&](const Point3& a, const Point3& b) {
    const int from = cmp(v(a), v(p)), to = cmp(v(b), v(p));
    if ((from > 0 && to > 0) || (from < 0 && to < 0)) return false;
    if (from == 0 && to == 0) return (u(a) <= u(p) && u(p) <= u(b)) || (u(b) <= u(p) && u(p) <= u(a));
    const Rational turn = (u(b) - u(a)) * (v(p) - v(a)) - (v(b) - v(a)) * (u(p) - u(a));
    if (turn == 0) return true;
    // A side counts where it passes the height of p, its lower end taken with it: p is left of one that rises.
    if ((from <= 0) != (to <= 0) && (from <= 0) == (turn > 0)) is_inside = !is_inside;
    return false;
  };
  const auto is_on_ring = [&](const std::vector<Point3>& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (is_on(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1])) return true;
    return false;
  };
  if (is_on_ring(polygon.points)) return true;
  for (const std::vector<Point3>& hole : polygon.holes)
    if (is_on_ring(hole)) return true;
  return is_inside;
}

Vector3 doubled_area(const Polygon3& polygon) {
  Vector3 sum = doubled_loop_area(polygon.points);
  for (const auto& hole : polygon.holes) {
    const Vector3 part = doubled_loop_area(hole);
    const int side = sgn(dot(sum, part));
    sum = {sum.x - side * part.x, sum.y - side * part.y, sum.z - side * part.z};
  }
  return sum;
}

}  // namespace hottel
