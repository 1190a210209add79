#include "geometry/space/scene/division.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool is_straight(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c) {
  return is_zero(cross(difference(b, a), difference(c, b)));
}

bool is_straight(const Point3& a, const Point3& b, const Point3& c) { return cross(b - a, c - b).is_zero(); }

template <class Point>
std::vector<Point> without_straight_corners(const std::vector<Point>& points) {
  std::vector<Point> corners;
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k)
    if (!is_straight(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) corners.push_back(points[k]);
  return corners;
}

// Two points, the ends of the longest side of all triangles of a polygon that is not convex.
std::vector<Point3> longest_triangle_sides(const Polygon3& polygon) {
  std::vector<Point3> ends;
  Rational longest;
  for (const auto& triangle : triangles_of(polygon))
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 side = triangle[(k + 1) % 3] - triangle[k];
      if (dot(side, side) <= longest) continue;
      longest = dot(side, side);
      ends = {triangle[k], triangle[(k + 1) % 3]};
    }
  return ends;
}

// The points of which the sides count: as listed where they are a triangle or a quad.
std::vector<Point3> frame_of(const Polygon3& polygon) {
  if (!is_convex(polygon)) return longest_triangle_sides(polygon);
  return polygon.points.size() <= 4 ? polygon.points : without_straight_corners(polygon.points);
}

// The least n >= 1 with n^2 >= squared.
Integer root_above(const Rational& squared) {
  Integer whole;
  mpz_cdiv_q(whole.get_mpz_t(), squared.get_num_mpz_t(), squared.get_den_mpz_t());
  Integer n = sqrt(whole);
  if (n * n < whole) ++n;
  return n;
}

// The least m with m^2 >= value. REQUIRES value < 2^50.
std::uint64_t root_above(std::uint64_t value) {
  auto m = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(value)));
  while (m * m < value) ++m;
  while (m > 0 && (m - 1) * (m - 1) >= value) --m;
  return m;
}

Integer integer(std::uint64_t value) { return Integer(static_cast<unsigned long>(value)); }

void add_multiple(IntegerVector& sum, const IntegerVector& a, std::uint64_t factor) {
  const auto times = static_cast<unsigned long>(factor);
  mpz_addmul_ui(sum.x.get_mpz_t(), a.x.get_mpz_t(), times);
  mpz_addmul_ui(sum.y.get_mpz_t(), a.y.get_mpz_t(), times);
  mpz_addmul_ui(sum.z.get_mpz_t(), a.z.get_mpz_t(), times);
}

// Twice the corners of a child of a triangle: what lies at a corner, or the middle, turned by half a turn.
std::vector<IntegerVector> triangle_child(const std::vector<IntegerVector>& triangle, int digit) {
  std::vector<IntegerVector> child;
  for (std::size_t c = 0; c < 3; ++c)
    child.push_back(digit < 3 ? sum(triangle[static_cast<std::size_t>(digit)], triangle[c])
                              : sum(triangle[(c + 1) % 3], triangle[(c + 2) % 3]));
  return child;
}

// (n - i - j) a + i b + j c, which is n times a point of the triangle; the first factor may be negative (of a
// parallelogram).
IntegerVector in_triangle(const std::array<const IntegerVector*, 3>& corners, std::uint64_t n, std::uint64_t i,
                          std::uint64_t j) {
  IntegerVector point;
  add_multiple(point, *corners[1], i);
  add_multiple(point, *corners[2], j);
  if (i + j <= n) {
    add_multiple(point, *corners[0], n - i - j);
    return point;
  }
  IntegerVector less;
  add_multiple(less, *corners[0], i + j - n);
  return difference(point, less);
}

bool has_trees(const Scene3& scene) {
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                     [](const Surface& surface) { return !surface.trees.is_empty(); });
}

}  // namespace

void divide_into(Scene3& scene, std::uint32_t n) {
  HOTTEL_REQUIRE(n > 0);
  for (Surface& surface : scene.surfaces) surface.elements = n;
}

std::optional<std::uint32_t> divide_by_length(Scene3& scene, const Rational& h, std::uint32_t most) {
  HOTTEL_REQUIRE(h > 0);
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const std::vector<Point3> frame = frame_of(scene.polygons[s]);
    Rational longest;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      const Vector3 side = frame[(k + 1) % frame.size()] - frame[k];
      longest = std::max(longest, dot(side, side));
    }
    const Integer n = root_above(Rational(longest / (h * h)));
    if (n > most) return s;
    scene.surfaces[s].elements = static_cast<std::uint32_t>(n.get_ui());
  }
  return std::nullopt;
}

void divide_into(ValidScene3& scene, std::uint32_t n) {
  HOTTEL_REQUIRE(n <= kMaxElements && !has_trees(scene.scene_));
  divide_into(scene.scene_, n);
}

std::optional<std::uint32_t> divide_by_length(ValidScene3& scene, const Rational& h, std::uint32_t most) {
  HOTTEL_REQUIRE(most <= kMaxElements && !has_trees(scene.scene_));
  return divide_by_length(scene.scene_, h, most);
}

std::vector<std::array<Point3, 3>> triangles_of(const Polygon3& polygon) {
  if (polygon.is_nearly_plane) {
    std::vector<std::array<Point3, 3>> facets;
    for (const Polygon3& facet : facets_of(polygon))
      facets.push_back({facet.points[0], facet.points[1], facet.points[2]});
    return facets;
  }
  const PlaneFrame3 frame(polygon.points);
  const FlatRegion3 region = frame.region(polygon.points, polygon.holes);
  std::vector<FlatSegment3> sides;
  region.append_sides(sides);
  const PlaneTriangulation3 triangulation(sides);
  const bool is_front_up = frame.is_front_up(polygon.points);
  std::vector<std::array<Point3, 3>> result;
  for (std::uint32_t t = 0; t < triangulation.triangles().size(); ++t) {
    if (!region.contains(triangulation.centre(t))) continue;
    const auto& corners = triangulation.triangles()[t].corners;
    const auto at = [&](std::size_t k) { return frame.point(triangulation.points()[corners[k]]); };
    result.push_back(std::array<Point3, 3>{at(0), at(is_front_up ? 1 : 2), at(is_front_up ? 2 : 1)});
  }
  return result;
}

std::uint64_t element_count(const Polygon3& polygon, std::uint32_t n) {
  if (n == 1) return 1;
  const std::uint64_t each = std::uint64_t{n} * n;
  if (!is_convex(polygon)) return each * triangles_of(polygon).size();
  return polygon.points.size() <= 4 ? each : each * (without_straight_corners(polygon.points).size() - 2);
}

std::uint32_t root_count(const Polygon3& polygon, std::uint32_t n) {
  if (n > 1) return static_cast<std::uint32_t>(element_count(polygon, n));
  if (!is_convex(polygon)) return static_cast<std::uint32_t>(triangles_of(polygon).size());
  return polygon.points.size() <= 4 ? 1
                                    : static_cast<std::uint32_t>(without_straight_corners(polygon.points).size() - 2);
}

PolygonDivision3::PolygonDivision3(std::vector<IntegerVector> points, std::uint32_t n, HasTrees3 has_trees) : n_(n) {
  HOTTEL_REQUIRE(n > 0 && points.size() >= 3);
  std::vector<IntegerVector> corners = without_straight_corners(points);
  if (n == 1 && has_trees == HasTrees3::kNo) {
    points_ = std::move(corners);
    return;
  }
  weight_ = integer(n_);
  if (points.size() != 4) {
    shape_ = Shape::kTriangles;
    points_ = std::move(corners);
    return;
  }
  shape_ = Shape::kQuad;
  has_straight_corner_ = corners.size() < 4;
  is_parallelogram_ = difference(points[1], points[0]) == difference(points[2], points[3]);
  if (!is_parallelogram_) weight_ *= integer(n_);
  points_ = std::move(points);
}

std::uint64_t PolygonDivision3::count() const {
  switch (shape_) {
    case Shape::kWhole:
      return 1;
    case Shape::kQuad:
      return n_ * n_;
    case Shape::kTriangles:
      break;
  }
  return n_ * n_ * (points_.size() - 2);
}

Integer PolygonDivision3::weight(int depth) const {
  const bool is_general = shape_ == Shape::kQuad && !is_parallelogram_;
  Integer result;
  mpz_mul_2exp(result.get_mpz_t(), weight_.get_mpz_t(), static_cast<mp_bitcnt_t>(is_general ? 2 * depth : depth));
  return result;
}

std::vector<IntegerVector> PolygonDivision3::corners(std::uint64_t k, const TreePath& path) const {
  HOTTEL_REQUIRE(shape_ != Shape::kWhole || path.depth() == 0);
  if (shape_ == Shape::kWhole) return points_;
  if (shape_ == Shape::kQuad) {
    std::vector<IntegerVector> quad = quad_element(k);
    for (int level = 0; level < path.depth(); ++level) quad = quad_child(quad, path.digit(level));
    return has_straight_corner_ ? without_straight_corners(quad) : quad;
  }
  std::vector<IntegerVector> triangle = triangle_element(k / (n_ * n_), k % (n_ * n_));
  for (int level = 0; level < path.depth(); ++level) triangle = triangle_child(triangle, path.digit(level));
  return triangle;
}

// In weights of the next depth.
std::vector<IntegerVector> PolygonDivision3::quad_child(const std::vector<IntegerVector>& quad, int digit) const {
  const unsigned long unit = is_parallelogram_ ? 1 : 2;
  IntegerVector centre = sum(quad[0], quad[2]);
  if (!is_parallelogram_) centre = sum(centre, sum(quad[1], quad[3]));
  std::vector<IntegerVector> child;
  for (int c = 0; c < 4; ++c) {
    if (c == (digit + 2) % 4) {
      child.push_back(centre);
      continue;
    }
    IntegerVector& corner = child.emplace_back();
    add_multiple(corner, quad[static_cast<std::size_t>(digit)], unit);
    add_multiple(corner, quad[static_cast<std::size_t>(c)], unit);
  }
  return child;
}

std::vector<IntegerVector> PolygonDivision3::quad_element(std::uint64_t k) const {
  const std::uint64_t i = k % n_, j = k / n_;
  std::vector<IntegerVector> corners;
  for (const auto& [a, b] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}) {
    if (is_parallelogram_) {
      corners.push_back(in_triangle({&points_[0], &points_[1], &points_[3]}, n_, a, b));
      continue;
    }
    IntegerVector& point = corners.emplace_back();
    add_multiple(point, points_[0], (n_ - a) * (n_ - b));
    add_multiple(point, points_[1], a * (n_ - b));
    add_multiple(point, points_[2], a * b);
    add_multiple(point, points_[3], (n_ - a) * b);
  }
  return corners;
}

std::vector<IntegerVector> PolygonDivision3::triangle_element(std::uint64_t triangle, std::uint64_t k) const {
  const std::array<const IntegerVector*, 3> frame{&points_[0], &points_[triangle + 1], &points_[triangle + 2]};
  // Row j has 2 (n - j) - 1 elements; m^2 stand in it and after it, with m = n - j.
  const std::uint64_t rest = n_ * n_ - k, m = root_above(rest), j = n_ - m, place = m * m - rest, i = place / 2;
  const auto at = [&](std::uint64_t a, std::uint64_t b) { return in_triangle(frame, n_, a, b); };
  if (place % 2 == 0) return {at(i, j), at(i + 1, j), at(i, j + 1)};
  return {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
}

}  // namespace hottel
