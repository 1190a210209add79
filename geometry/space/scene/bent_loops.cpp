#include "geometry/space/scene/bent_loops.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space/scene/plane_triangulation.h"

namespace hottel {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Ways = std::vector<std::array<double, 3>>;

// The square of the area of a triangle, times 16, rounded.
double squared_area(const Ways& p, std::size_t a, std::size_t b, std::size_t c) {
  const double ux = p[b][0] - p[a][0], uy = p[b][1] - p[a][1], uz = p[b][2] - p[a][2];
  const double vx = p[c][0] - p[a][0], vy = p[c][1] - p[a][1], vz = p[c][2] - p[a][2];
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  return x * x + y * y + z * z;
}

// The normal of the largest triangle, and one of its corners.
std::pair<Vector3, const Point3*> largest_triangle(const std::vector<Point3>& points) {
  constexpr double kSlack = 1e-9;  // far above what rounding makes of the largest
  Ways ways;
  double size = 0;
  for (const Point3& point : points) {
    const Vector3 way = point - points[0];
    ways.push_back({to_double(way.x), to_double(way.y), to_double(way.z)});
    for (const double part : ways.back()) size = std::max(size, std::abs(part));
  }
  for (auto& way : ways)
    for (double& part : way) part /= size;
  double largest = 0;
  const std::size_t n = points.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c) largest = std::max(largest, squared_area(ways, a, b, c));
  std::pair<Vector3, const Point3*> result{{}, &points[0]};
  Rational most = -1;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c) {
        if (squared_area(ways, a, b, c) < (1 - kSlack) * largest) continue;
        Vector3 normal = cross(points[b] - points[a], points[c] - points[a]);
        Rational area = square(normal);
        if (area <= most) continue;
        most = std::move(area);
        result = {std::move(normal), &points[a]};
      }
  return result;
}

// Two coordinates of each point, the third left out along which the area is largest; the first loop goes around
// counter-clockwise.
std::vector<std::vector<FlatPoint3>> seen(const std::vector<std::vector<Point3>>& loops, const Vector3& area) {
  const Rational x = abs(area.x), y = abs(area.y), z = abs(area.z);
  const bool along_x = x >= y && x >= z, along_y = !along_x && y >= z;
  const bool turns = sgn(along_x ? area.x : along_y ? area.y : area.z) < 0;
  std::vector<std::vector<FlatPoint3>> result;
  for (const auto& loop : loops) {
    auto& flat = result.emplace_back();
    for (const Point3& p : loop) {
      FlatPoint3 point = along_x ? FlatPoint3{p.y, p.z} : along_y ? FlatPoint3{p.z, p.x} : FlatPoint3{p.x, p.y};
      if (turns) std::swap(point.u, point.v);
      flat.push_back(std::move(point));
    }
  }
  return result;
}

// All triangles with the first point; none where the loop turns back, or one of them has no area.
std::vector<Corners> fan(const std::vector<FlatPoint3>& p) {
  const auto n = static_cast<std::uint32_t>(p.size());
  std::vector<Corners> triangles;
  for (std::uint32_t k = 0; k < n; ++k) {
    if (doubled_area(p[k], p[(k + 1) % n], p[(k + 2) % n]) < 0) return {};
    if (k == 0 || k + 1 == n) continue;
    if (doubled_area(p[0], p[k], p[k + 1]) <= 0) return {};
    triangles.push_back({0, k, k + 1});
  }
  return triangles;
}

bool are_different(const std::vector<FlatPoint3>& points) {
  std::vector<const FlatPoint3*> order;
  for (const FlatPoint3& point : points) order.push_back(&point);
  std::sort(order.begin(), order.end(), [](const FlatPoint3* a, const FlatPoint3* b) {
    const int side = cmp(a->u, b->u);
    return side != 0 ? side < 0 : a->v < b->v;
  });
  return std::adjacent_find(order.begin(), order.end(),
                            [](const FlatPoint3* a, const FlatPoint3* b) { return *a == *b; }) == order.end();
}

// The triangles inside loops; none where they cross or touch.
std::vector<Corners> inside(const std::vector<std::vector<FlatPoint3>>& loops) {
  std::vector<FlatPoint3> points;
  Rational told;
  for (const auto& loop : loops) {
    points.insert(points.end(), loop.begin(), loop.end());
    const Rational area = abs(doubled_area(loop));
    told += &loop == loops.data() ? area : Rational(-area);
  }
  if (!are_different(points)) return {};
  const FlatRegion3 region(loops);
  std::vector<PlaneTriangulation3::Segment> sides;
  region.append_sides(sides);
  const PlaneTriangulation3 triangulation(sides);
  if (triangulation.points() != points) return {};
  std::vector<Corners> triangles;
  Rational area;
  for (std::uint32_t k = 0; k < triangulation.triangles().size(); ++k) {
    if (!region.contains(triangulation.centre(k))) continue;
    area += triangulation.doubled_area_of(k);
    triangles.push_back(triangulation.triangles()[k].corners);
  }
  if (area != told) return {};  // it goes around more than once, or a hole is not in it
  return triangles;
}

}  // namespace

bool are_in_one_plane(const std::vector<Point3>& points) {
  Vector3 first, normal;
  for (const Point3& point : points) {
    const Vector3 way = point - points[0];
    if (first.is_zero())
      first = way;
    else if (normal.is_zero())
      normal = cross(first, way);
    else if (dot(normal, way) != 0)
      return false;
  }
  return true;
}

Rational squared_diameter(const std::vector<Point3>& points) {
  Rational most;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) most = std::max(most, square(points[a] - points[b]));
  return most;
}

Bend3 bend_of(const std::vector<Point3>& points) {
  Bend3 result{0, squared_diameter(points), points[0]};
  if (are_in_one_plane(points)) return result;
  const auto [normal, anchor] = largest_triangle(points);
  Rational most;
  for (const Point3& point : points)
    if (const Rational height = abs(dot(normal, point - *anchor)); height > most) {
      most = height;
      result.farthest = point;
    }
  result.squared_distance = most * most / square(normal);
  return result;
}

Vector3 doubled_loop_area(const std::vector<Point3>& loop) {
  Vector3 sum;
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const Vector3 part = cross(loop[k - 1] - loop[0], loop[k] - loop[0]);
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return sum;
}

std::vector<Corners> triangles_of_loops(const std::vector<std::vector<Point3>>& loops) {
  const Vector3 area = doubled_loop_area(loops.front());
  if (area.is_zero()) return {};
  const auto flat = seen(loops, area);
  std::vector<Corners> corners = inside(flat);
  if (corners.empty() || loops.size() > 1) return corners;
  std::vector<Corners> all = fan(flat.front());
  return all.empty() ? corners : all;
}

}  // namespace hottel
