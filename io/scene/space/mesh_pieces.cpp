#include "io/scene/space/mesh_pieces.h"

#include "geometry/space/scene/division.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool are_on_one_line(const Point3& a, const Point3& b, const Point3& c) { return cross(b - a, c - a).is_zero(); }

std::vector<Polygon3> triangles_of_convex(const Polygon3& polygon) {
  std::vector<Polygon3> result;
  std::vector<Point3> rest = polygon.points;
  // Corners b are cut off, from the second point on, if both the triangle a b c and what is left have an area: the
  // latter iff the point after c is not on the line of a and c. There is such a corner among four points or more: of
  // two that are not next to each other either will do, and of a triangle with points in its sides one beside such a
  // point.
  std::size_t k = 1;
  while (rest.size() > 3) {
    const std::size_t n = rest.size();
    for (std::size_t tried = 0;; ++tried, ++k) {
      HOTTEL_REQUIRE(tried < n);
      const Point3 &a = rest[(k + n - 1) % n], &b = rest[k % n], &c = rest[(k + 1) % n], &d = rest[(k + 2) % n];
      if (are_on_one_line(a, b, c) || are_on_one_line(a, c, d)) continue;
      result.push_back({{a, b, c}});
      break;
    }
    k %= n;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
  }
  result.push_back({std::move(rest)});
  return result;
}

}  // namespace

std::vector<Polygon3> mesh_triangles(const Polygon3& polygon) {
  if (is_convex(polygon)) return triangles_of_convex(polygon);
  std::vector<Polygon3> result;
  for (const auto& [a, b, c] : triangles_of(polygon)) result.push_back({{a, b, c}});
  return result;
}

}  // namespace hottel
