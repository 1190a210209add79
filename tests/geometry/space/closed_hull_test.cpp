// What ClosedHull3 says of scenes, and that it is so.
#include "geometry/space/arrangement/closed_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel::closed_hull_test {
namespace {

// A cube with fronts inside, its first walls turned over, and a square within.
std::vector<Polygon3> cube_with_square(std::size_t turned) {
  std::vector<Polygon3> polygons{
      {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}, {{{0, 0, 2}, {0, 2, 2}, {2, 2, 2}, {2, 0, 2}}},
      {{{0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}}}, {{{0, 2, 0}, {2, 2, 0}, {2, 2, 2}, {0, 2, 2}}},
      {{{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}}}, {{{2, 0, 0}, {2, 0, 2}, {2, 2, 2}, {2, 2, 0}}}};
  for (std::size_t s = 0; s < turned; ++s) std::reverse(polygons[s].points.begin(), polygons[s].points.end());
  polygons.push_back({{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}});
  return polygons;
}

TEST(ClosedHull3, WhicheverSideOfTheWallsIsInside) {
  for (const std::size_t turned : {0, 1, 4, 6}) {
    const ClosedHull3 hull{Occluders3(cube_with_square(turned))};
    ASSERT_TRUE(hull.is_closed());
    for (std::uint32_t s = 0; s < 6; ++s) {
      EXPECT_EQ(hull.sees_no_sky(s, s < turned), true);
      EXPECT_EQ(hull.sees_no_sky(s, s >= turned), false);
    }
    EXPECT_TRUE(hull.sees_no_sky(6, false));
    EXPECT_TRUE(hull.sees_no_sky(6, true));
  }
}

TEST(ClosedHull3, NotWhereAPartOfAWallIsMissing) {
  const std::vector<Polygon3> whole = cube_with_square(2);
  for (std::size_t missing = 0; missing < 6; ++missing) {
    std::vector<Polygon3> polygons = whole;
    polygons.erase(polygons.begin() + static_cast<std::ptrdiff_t>(missing));
    const ClosedHull3 hull{Occluders3(polygons)};
    EXPECT_FALSE(hull.is_closed());
    for (std::uint32_t s = 0; s < polygons.size(); ++s) EXPECT_FALSE(hull.sees_no_sky(s, false));
  }
  std::vector<Polygon3> slit = whole;
  slit[5].points[1] = {2, Rational(1) / 1000000007, 2};
  EXPECT_FALSE(ClosedHull3{Occluders3(slit)}.is_closed());
}

TEST(ClosedHull3, WallsMayBeDividedAnyhow) {
  std::vector<Polygon3> polygons = cube_with_square(0);
  polygons[0].points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  EXPECT_FALSE(ClosedHull3{Occluders3(polygons)}.is_closed());
  polygons.push_back({{{0, 1, 0}, {Rational(2) / 3, 1, 0}, {Rational(2) / 3, 2, 0}, {0, 2, 0}}});
  EXPECT_FALSE(ClosedHull3{Occluders3(polygons)}.is_closed());
  polygons.push_back({{{Rational(2) / 3, 1, 0}, {2, 1, 0}, {2, 2, 0}, {Rational(2) / 3, 2, 0}}});
  const ClosedHull3 hull{Occluders3(polygons)};
  EXPECT_TRUE(hull.is_closed());
  for (const std::uint32_t s : {0u, 7u, 8u}) {
    EXPECT_TRUE(hull.sees_no_sky(s, false));
    EXPECT_FALSE(hull.sees_no_sky(s, true));
  }
}

TEST(ClosedHull3, NotOfASceneInOnePlane) {
  const ClosedHull3 hull{Occluders3({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}}})};
  EXPECT_FALSE(hull.is_closed());
  EXPECT_FALSE(hull.sees_no_sky(0, false));
}

// What it says of a room with boxes that touch, measured.
TEST(ClosedHull3, TheSkyIsNotMeasuredWhereItSaysSo) {
  Scene3 scene;
  scene.materials.push_back({"white", Spectrum::scalar(Rational(1) / 2), {}});
  for (const Polygon3& polygon : cube_with_square(0)) {
    Surface surface;
    surface.name = "polygon" + std::to_string(scene.surfaces.size());
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.emplace_back(surface.name);
    scene.add(std::move(surface), Polygon3(polygon));
  }
  const PreparedScene3 prepared = prepare(std::move(scene));
  const ClosedHull3 hull(prepared.occluders());
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  int measured = 0;
  for (const ElementTable3::Part& part : table.parts()) {
    if (part.patch.is_sky() || !hull.sees_no_sky(part.patch.surface, part.is_back)) continue;
    for (const ElementTable3::Part& sky : table.parts(table.sky())) {
      EXPECT_EQ(prepared.measurer().measure(part.patch, sky.patch).bounds.upper, 0);
      ++measured;
    }
  }
  EXPECT_GT(measured, 6);
}

}  // namespace
}  // namespace hottel::closed_hull_test
