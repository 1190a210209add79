#include "geometry/space/scene/triangulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "geometry/name.h"
#include "geometry/space/scene/plane_triangulation.h"

namespace hottel {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// Two coordinates of each corner, the third left out along which the area is largest; they go around counter-clockwise.
std::vector<FlatPoint3> seen(const Polygon3& polygon, const Vector3& area) {
  const Rational x = abs(area.x), y = abs(area.y), z = abs(area.z);
  const bool along_x = x >= y && x >= z, along_y = !along_x && y >= z;
  const bool turns = sgn(along_x ? area.x : along_y ? area.y : area.z) < 0;
  std::vector<FlatPoint3> points;
  for (const Point3& p : polygon.points) {
    FlatPoint3 point = along_x ? FlatPoint3{p.y, p.z} : along_y ? FlatPoint3{p.z, p.x} : FlatPoint3{p.x, p.y};
    if (turns) std::swap(point.u, point.v);
    points.push_back(std::move(point));
  }
  return points;
}

// All triangles with the first corner; none where the outline turns back, or one of them has no area.
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

// The triangles inside an outline; none where it crosses or touches itself.
std::vector<Corners> inside(const std::vector<FlatPoint3>& points) {
  if (!are_different(points)) return {};
  const FlatRegion3 region({points});
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
  if (area != doubled_area(points)) return {};  // it goes around more than once
  return triangles;
}

}  // namespace

std::vector<Polygon3> triangles_of_not_plane(const Polygon3& polygon) {
  const std::vector<Point3>& points = polygon.points;
  if (points.size() < 4 || !polygon.holes.empty()) return {};
  const Vector3 area = doubled_area(polygon);
  const auto is_off = [&](const Point3& point) { return dot(area, point - points[0]) != 0; };
  if (area.is_zero() || std::none_of(points.begin(), points.end(), is_off)) return {};
  const std::vector<FlatPoint3> outline = seen(polygon, area);
  std::vector<Corners> corners = inside(outline);
  if (corners.empty()) return {};
  if (std::vector<Corners> all = fan(outline); !all.empty()) corners = std::move(all);
  std::vector<Polygon3> triangles;
  for (const auto& [a, b, c] : corners) triangles.push_back({{points[a], points[b], points[c]}, {}});
  return triangles;
}

bool Triangulator3::add(Scene3& scene, const Surface& surface, const Polygon3& polygon) {
  std::vector<Polygon3> pieces = triangles_of_not_plane(polygon);
  if (pieces.empty()) return false;
  if (names_.empty()) first_problem_ = polygon_problem(polygon).text;
  names_.push_back(surface.name);
  triangles_ += pieces.size();
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    Surface piece = surface;
    piece.name = piece_name(surface.name, k);
    scene.add(std::move(piece), std::move(pieces[k]));
  }
  return true;
}

std::string Triangulator3::note() const {
  if (names_.empty()) return "";
  if (names_.size() == 1)
    return fmt::format("{} {}; it is read as {} triangles", quoted_name(names_[0]), first_problem_, triangles_);
  return fmt::format("{} polygons are not plane and are read as {} triangles: {}; {} {}", names_.size(), triangles_,
                     listed_names(names_), quoted_name(names_[0]), first_problem_);
}

}  // namespace hottel
