#include "geometry/space/scene/triangulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace hottel::triangulator_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

Polygon3 polygon(std::vector<Point3> points) { return {std::move(points), {}}; }

// A star of n points around the axis, every other one close to it, at heights of any kind: bent and not convex.
Polygon3 bent_star(int n, std::mt19937& random) {
  Polygon3 result;
  const auto number = [&](int low, int high) { return low + static_cast<int>(random() % (high - low + 1)); };
  for (int k = 0; k < n; ++k) {
    // Half-way around by rational angles: the point (1 - t^2, 2 t) / (1 + t^2), t from -8 to 8.
    Rational t(16 * k - 8 * n + number(1, 3), n);
    t.canonicalize();
    const Rational radius(number(k % 2 == 0 ? 8 : 2, k % 2 == 0 ? 12 : 4));
    const Rational whole = 1 + t * t;
    result.points.push_back({radius * (1 - t * t) / whole, radius * 2 * t / whole, Rational(number(-3, 3), 1)});
  }
  return result;
}

Rational doubled_area_from_above(const Polygon3& polygon) { return doubled_area(polygon).z; }

using Side = std::pair<std::string, std::string>;
std::vector<Side> sides(const Polygon3& polygon) {
  std::vector<Side> result;
  for (std::size_t k = 0; k < polygon.points.size(); ++k)
    result.emplace_back(place_text(polygon.points[k]), place_text(polygon.points[(k + 1) % polygon.points.size()]));
  return result;
}

// Properties (1) and (2).
void expect_cut(const Polygon3& whole, const std::vector<Polygon3>& triangles) {
  ASSERT_EQ(triangles.size(), whole.points.size() - 2);
  std::map<Side, int> count;
  Rational area;
  for (const Polygon3& triangle : triangles) {
    EXPECT_EQ(polygon_problem(triangle).text, "");
    EXPECT_EQ(triangle.points.size(), 3u);
    EXPECT_GT(doubled_area_from_above(triangle) * doubled_area_from_above(whole), 0);
    area += doubled_area_from_above(triangle);
    for (const Side& side : sides(triangle)) ++count[side];
  }
  EXPECT_EQ(area, doubled_area_from_above(whole));
  for (const Side& side : sides(whole)) {
    EXPECT_EQ(count[side], 1);
    EXPECT_FALSE(count.contains({side.second, side.first}));
    count.erase(side);
  }
  for (const auto& [side, times] : count) {
    EXPECT_EQ(times, 1);
    EXPECT_TRUE(count.contains({side.second, side.first}));
  }
}

TEST(Triangulator, TrianglesHaveTheCornersAndSidesOfThePolygonAndCoverWhatItCovers) {
  std::mt19937 random(7);
  int bent = 0;
  for (int n = 4; n < 24; ++n)
    for (int k = 0; k < 5; ++k) {
      Polygon3 star = bent_star(n, random);
      if (k % 2 == 1) std::reverse(star.points.begin(), star.points.end());
      const std::vector<Polygon3> triangles = triangles_of_not_plane(star);
      if (triangles.empty()) continue;  // plane, or steeper than it is wide
      const Vector3 area = doubled_area(star);
      if (abs(area.x) > abs(area.z) || abs(area.y) > abs(area.z)) continue;
      ++bent;
      expect_cut(star, triangles);
    }
  EXPECT_GT(bent, 60);
}

TEST(Triangulator, ConvexOnesAreCutFromTheFirstCorner) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, Rational(1, 3)}, d{0, 1, 0};
  for (const auto& turn : {std::vector{a, b, c, d}, {b, c, d, a}, {c, d, a, b}, {d, c, b, a}, {c, b, a, d}})
    EXPECT_EQ(triangles_of_not_plane(polygon(turn)),
              (std::vector{polygon({turn[0], turn[1], turn[2]}), polygon({turn[0], turn[2], turn[3]})}));
}

TEST(Triangulator, OthersAreDelaunayAsSeen) {
  const Point3 a{0, 0, 1}, b{4, 0, 0}, c{1, 1, 0}, d{0, 4, 0};  // an arrowhead: only the side a c is inside
  for (const auto& turn : {std::vector{a, b, c, d}, {b, c, d, a}}) {
    const std::vector<Polygon3> triangles = triangles_of_not_plane(polygon(turn));
    expect_cut(polygon(turn), triangles);
    for (const Polygon3& triangle : triangles) {
      EXPECT_EQ(std::count(triangle.points.begin(), triangle.points.end(), a), 1);
      EXPECT_EQ(std::count(triangle.points.begin(), triangle.points.end(), c), 1);
    }
  }
}

TEST(Triangulator, WhatStandsUprightIsCutToo) {
  const std::vector<Polygon3> triangles =
      triangles_of_not_plane(polygon({{0, 0, 0}, {0, 2, 0}, {Rational(1, 9), 2, 2}, {0, 0, 2}}));
  ASSERT_EQ(triangles.size(), 2u);
  for (const Polygon3& triangle : triangles) EXPECT_GT(doubled_area(triangle).x, 0);
}

TEST(Triangulator, WhatIsPlaneOrCannotBeCutIsLeft) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, Rational(1, 3)}, d{0, 1, 0};
  EXPECT_THAT(triangles_of_not_plane(polygon({a, b, c})), IsEmpty());
  EXPECT_THAT(triangles_of_not_plane(polygon({a, b, {1, 1, 0}, d})), IsEmpty());
  EXPECT_THAT(triangles_of_not_plane(polygon({a, b, d, c})), IsEmpty());  // crosses itself, and has no area from above
  EXPECT_THAT(triangles_of_not_plane(polygon({a, b, c, a, d})), IsEmpty());
  EXPECT_THAT(triangles_of_not_plane(polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {1, -1, 0}})), IsEmpty());
  // A hole that is cut out, and one that is not in it.
  EXPECT_THAT(
      triangles_of_not_plane({{{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}}),
      SizeIs(7));
  EXPECT_THAT(
      triangles_of_not_plane({{{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}, {{{5, 1, 0}, {6, 1, 0}, {5, 2, 0}}}}),
      IsEmpty());
  // Twice around.
  EXPECT_THAT(triangles_of_not_plane(polygon(
                  {{4, 0, 0}, {0, 4, 1}, {-4, 0, 0}, {0, -4, 0}, {5, 0, 2}, {0, 5, 0}, {-5, 0, 0}, {0, -5, 0}})),
              IsEmpty());
}

TEST(Triangulator, SurfacesKeepAllButTheirNamesAndTheNoteTellsThem) {
  Scene3 scene;
  Triangulator3 triangulator;
  Surface surface;
  surface.name = "roof";
  surface.elements = 3;
  surface.group = 5;
  surface.line = 12;
  EXPECT_FALSE(triangulator.add(scene, surface, polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})));
  EXPECT_EQ(triangulator.note(), "");
  EXPECT_TRUE(scene.surfaces.empty());
  const Polygon3 bent = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, Rational(1, 4)}, {0, 1, 0}});
  EXPECT_TRUE(triangulator.add(scene, surface, bent));
  ASSERT_EQ(scene.surfaces.size(), 2u);
  EXPECT_EQ(scene.polygons.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(scene.surfaces[k].name, "roof[" + std::to_string(k) + "]");
    EXPECT_EQ(scene.surfaces[k].elements, 3u);
    EXPECT_EQ(scene.surfaces[k].group, 5u);
    EXPECT_EQ(scene.surfaces[k].line, 12);
  }
  EXPECT_THAT(triangulator.note(), StartsWith("'roof' is not plane: points lie "));
  EXPECT_THAT(triangulator.note(), HasSubstr("it is read as 2 triangles"));
  surface.name = "wall";
  EXPECT_TRUE(triangulator.add(scene, surface, bent));
  EXPECT_THAT(triangulator.note(), StartsWith("2 polygons are not plane and are read as 4 triangles: 'roof'"));
}

}  // namespace
}  // namespace hottel::triangulator_test
