// Which points see each other: against rationals, and where segments meet edges and corners.
#include "solver/space/methods/segment_visibility.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <vector>

namespace hottel::segment_visibility_test {
namespace {

constexpr std::uint32_t kNoSurface = 0xfffffffe;

Occluders3 occluders_of(const std::vector<std::vector<std::array<int, 3>>>& outlines) {
  std::vector<Polygon3> polygons;
  for (const auto& outline : outlines) {
    Polygon3& polygon = polygons.emplace_back();
    for (const auto& [x, y, z] : outline) polygon.points.push_back({x, y, z});
  }
  return Occluders3(polygons);
}

// In the doubles of the vertices, whose first is the origin of theirs: outlines here begin at 0, 0, 0.
SurfacePoint3 at(double x, double y, double z) { return {{x, y, z}, kNoSurface}; }

// Whether a segment meets the inside of a triangle, by rationals; nothing where it meets its border or plane.
std::optional<bool> meets(const std::vector<std::array<int, 3>>& triangle, const std::array<int, 3>& p,
                          const std::array<int, 3>& q) {
  const auto det = [](const std::array<int, 3>& a, const std::array<int, 3>& b, const std::array<int, 3>& c,
                      const std::array<int, 3>& d) {
    long m[3][3];
    for (int k = 0; k < 3; ++k) {
      m[0][k] = b[k] - a[k];
      m[1][k] = c[k] - a[k];
      m[2][k] = d[k] - a[k];
    }
    const long value = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  };
  const int before = det(triangle[0], triangle[1], triangle[2], p),
            after = det(triangle[0], triangle[1], triangle[2], q);
  if (before == 0 || after == 0) return std::nullopt;
  if (before == after) return false;
  const int a = det(p, q, triangle[0], triangle[1]), b = det(p, q, triangle[1], triangle[2]),
            c = det(p, q, triangle[2], triangle[0]);
  if (a == 0 || b == 0 || c == 0) return std::nullopt;
  return a == b && b == c;
}

TEST(SegmentVisibility3, AgreesWithIntegers) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> small(-9, 9);
  const auto point = [&] { return std::array<int, 3>{small(random), small(random), small(random)}; };
  int hidden = 0, free = 0;
  for (int scene = 0; scene < 200; ++scene) {
    std::vector<std::vector<std::array<int, 3>>> triangles;
    while (triangles.size() < 12) {
      std::vector<std::array<int, 3>> triangle{point(), point(), point()};
      if (triangles.empty()) triangle[0] = {0, 0, 0};
      bool is_flat = true;  // on one line
      for (int k = 0; k < 3 && is_flat; ++k) {
        const int l = (k + 1) % 3;
        is_flat = (triangle[1][k] - triangle[0][k]) * (triangle[2][l] - triangle[0][l]) ==
                  (triangle[1][l] - triangle[0][l]) * (triangle[2][k] - triangle[0][k]);
      }
      if (!is_flat) triangles.push_back(triangle);
    }
    const Occluders3 occluders = occluders_of(triangles);
    const double unit = to_double(scaled_by_power_of_two(occluders.vertices().scale(), occluders.vertices().shift()));
    const SegmentVisibility3 visibility(occluders);
    for (int k = 0; k < 50; ++k) {
      const auto p = point(), q = point();
      bool is_free = true, is_sure = p != q;
      for (const auto& triangle : triangles) {
        const auto met = meets(triangle, p, q);
        if (!met) is_sure = false;
        if (met && *met) is_free = false;
      }
      if (!is_sure) continue;
      const SurfacePoint3 from = at(p[0] / unit, p[1] / unit, p[2] / unit),
                          to = at(q[0] / unit, q[1] / unit, q[2] / unit);
      EXPECT_EQ(visibility.see_each_other(from, to), is_free) << scene << " " << k;
      EXPECT_EQ(visibility.see_each_other(to, from), is_free) << scene << " " << k;
      ++(is_free ? free : hidden);
    }
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_GT(free, 1000);
}

// A square of two triangles and one of four: whatever meets an inner edge or the middle is hidden, and on the border of
// the square each segment is hidden by exactly one of two squares beside each other.
TEST(SegmentVisibility3, NothingSlipsBetweenPolygonsThatShareAnEdge) {
  const Occluders3 halves = occluders_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, {{0, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
  const Occluders3 quarters = occluders_of({{{0, 0, 0}, {4, 0, 0}, {2, 2, 0}},
                                            {{4, 0, 0}, {4, 4, 0}, {2, 2, 0}},
                                            {{4, 4, 0}, {0, 4, 0}, {2, 2, 0}},
                                            {{0, 4, 0}, {0, 0, 0}, {2, 2, 0}}});
  for (const Occluders3* occluders : {&halves, &quarters}) {
    const double unit = to_double(scaled_by_power_of_two(occluders->vertices().scale(), occluders->vertices().shift()));
    const SegmentVisibility3 visibility(*occluders);
    for (double x = 0.25; x < 4; x += 0.25)
      for (double y = 0.25; y < 4; y += 0.25)
        for (const double lean : {-0.5, 0.0, 0.5}) {
          const SurfacePoint3 above = at((x + lean) / unit, y / unit, 1 / unit);
          const SurfacePoint3 below = at((x - lean) / unit, y / unit, -1 / unit);
          EXPECT_FALSE(visibility.see_each_other(above, below)) << x << " " << y << " " << lean;
        }
  }
  const Occluders3 left = occluders_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
  const Occluders3 right = occluders_of({{{4, 0, 0}, {8, 0, 0}, {8, 4, 0}, {4, 4, 0}}});
  const auto is_free = [](const Occluders3& occluders, double x, double y) {
    const Vertices3& vertices = occluders.vertices();
    const double unit = to_double(scaled_by_power_of_two(vertices.scale(), vertices.shift()));
    const double first = to_double(vertices.origin().x);
    return SegmentVisibility3(occluders).see_each_other(at((x - first) / unit, y / unit, 1 / unit),
                                                        at((x - first) / unit, y / unit, -1 / unit));
  };
  for (double y = 0.5; y < 4; y += 0.5) EXPECT_NE(is_free(left, 4, y), is_free(right, 4, y)) << y;
}

TEST(SegmentVisibility3, APolygonHidesNothingFromItsOwnPointsAndTheSkyIsBeyondAll) {
  const Occluders3 floor_and_roof =
      occluders_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 1}, {1, 3, 1}, {3, 3, 1}, {3, 1, 1}}});
  const double unit =
      to_double(scaled_by_power_of_two(floor_and_roof.vertices().scale(), floor_and_roof.vertices().shift()));
  const SegmentVisibility3 visibility(floor_and_roof);
  const SurfacePoint3 on_floor{{2 / unit, 2 / unit, 0}, 0}, aside{{0.5 / unit, 0.5 / unit, 0}, 0};
  EXPECT_FALSE(visibility.sees_sky(on_floor, {0, 0, 1}));
  EXPECT_TRUE(visibility.sees_sky(aside, {0, 0, 1}));
  EXPECT_TRUE(visibility.see_each_other(on_floor, {{2 / unit, 2 / unit, 1 / unit}, 1}));
  EXPECT_FALSE(visibility.see_each_other(on_floor, {{2 / unit, 2 / unit, 2 / unit}, kNoSurface}));
}

}  // namespace
}  // namespace hottel::segment_visibility_test
