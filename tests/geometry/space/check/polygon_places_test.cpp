#include "geometry/space/scene/polygon_places.h"

#include <gtest/gtest.h>

#include "geometry/space/contacts/corner_table.h"
#include "tests/geometry/space/check/small_scene.h"

namespace hottel::polygon_places_test {
namespace {

using testing_space::q;
using Part = ClosestPoint3::Part;

// An L of 2 by 2 without its upper right quarter, in the plane z = 1.
Polygon3 angle_piece() {
  Polygon3 polygon;
  polygon.points = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
  return polygon;
}

Polygon3 square_with_hole() {
  Polygon3 polygon;
  polygon.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  polygon.holes = {{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}};
  return polygon;
}

// 4 by 3 in the plane y = 0, with a hole along its lower side.
Polygon3 wall_with_a_door() {
  Polygon3 polygon;
  polygon.points = {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}};
  polygon.holes = {{{1, 0, 0}, {1, 0, 2}, {2, 0, 2}, {2, 0, 0}}};
  return polygon;
}

TEST(PolygonPlaces3, CoverConvexOrNotWithHolesAndBorders) {
  EXPECT_TRUE(contains(angle_piece(), {q("1/2"), q("3/2"), 1}));
  EXPECT_TRUE(contains(angle_piece(), {1, q("3/2"), 1}));
  EXPECT_TRUE(contains(angle_piece(), {q("1/2"), 1, 1}));  // at the height of corners
  EXPECT_FALSE(contains(angle_piece(), {q("3/2"), q("3/2"), 1}));
  EXPECT_FALSE(contains(angle_piece(), {-1, 1, 1}));
  EXPECT_FALSE(contains(angle_piece(), {q("1/2"), q("1/2"), 2}));
  EXPECT_FALSE(contains(square_with_hole(), {2, 2, 0}));
  EXPECT_TRUE(contains(square_with_hole(), {q("1/2"), 2, 0}));
  EXPECT_TRUE(contains(square_with_hole(), {3, 2, 0}));
}

TEST(PolygonPlaces3, ClosestPointsAreInsideOnSidesOrCorners) {
  const ClosestPoint3 above = closest_point(angle_piece(), {q("1/2"), q("1/2"), 3});
  EXPECT_EQ(above.at, (Point3{q("1/2"), q("1/2"), 1}));
  EXPECT_EQ(above.squared, 4);
  EXPECT_EQ(above.part, Part::kInside);
  const ClosestPoint3 side = closest_point(angle_piece(), {q("3/2"), q("5/4"), 1});
  EXPECT_EQ(side.at, (Point3{q("3/2"), 1, 1}));
  EXPECT_EQ(side.squared, q("1/16"));
  EXPECT_EQ(side.part, Part::kSide);
  const ClosestPoint3 corner = closest_point(angle_piece(), {3, -1, 1});
  EXPECT_EQ(corner.at, (Point3{2, 0, 1}));
  EXPECT_EQ(corner.squared, 2);
  EXPECT_EQ(corner.part, Part::kCorner);
  EXPECT_EQ(closest_point(angle_piece(), {1, 0, 2}).part, Part::kSide);  // above a side
  EXPECT_EQ(closest_point(square_with_hole(), {2, q("3/2"), 0}).at, (Point3{2, 1, 0}));
}

TEST(PolygonPlaces3, InsidesOfEdgesAreClosestWhereTheyPassByEachOther) {
  const auto both = closest_insides({{0, 0, 0}, {2, 0, 0}}, {{1, -1, 1}, {1, 3, 1}});
  ASSERT_TRUE(both);
  EXPECT_EQ(both->from, (Point3{1, 0, 0}));
  EXPECT_EQ(both->to, (Point3{1, 0, 1}));
  EXPECT_FALSE(closest_insides({{0, 0, 0}, {2, 0, 0}}, {{0, 1, 0}, {2, 1, 0}}));   // parallel
  EXPECT_FALSE(closest_insides({{0, 0, 0}, {2, 0, 0}}, {{1, 0, 1}, {1, 3, 1}}));   // at an end
  EXPECT_FALSE(closest_insides({{0, 0, 0}, {2, 0, 0}}, {{3, -1, 1}, {3, 3, 1}}));  // beyond
}

TEST(PolygonPlaces3, SidesHaveThePolygonOnTheirLeftWhateverTheSenseOfHoles) {
  Polygon3 other = square_with_hole();
  std::reverse(other.holes[0].begin(), other.holes[0].end());
  for (const Polygon3& polygon : {square_with_hole(), other}) {
    const std::vector<Side3> sides = sides_of(polygon);
    ASSERT_EQ(sides.size(), 8u);
    for (const Side3& side : sides) {
      const Vector3 along = side.to - side.from, left{-along.y, along.x, along.z};
      EXPECT_TRUE(contains(polygon, moved(moved(side.from, q("1/2"), along), q("1/100"), left)));
    }
  }
}

TEST(PolygonPlaces3, TheWidthIsThatOfTheNarrowestPlace) {
  EXPECT_EQ(squared_width(angle_piece()), 1);
  Polygon3 needle;
  needle.points = {{0, 0, 0}, {10, 0, 0}, {5, q("1/100"), 0}};
  EXPECT_EQ(squared_width(needle), q("1/10000"));
}

TEST(PolygonPlaces3, AHoleOnTheOutlineIsNoNarrowPlace) {
  const Polygon3 wall = wall_with_a_door();
  EXPECT_EQ(squared_width(wall), 1) << "of the door itself, and beside it";
  EXPECT_NEAR(width_above(CornerTable3({wall}), 0), 1, 1e-12);
  Polygon3 strips = wall;  // two pieces that are nowhere joined
  strips.holes = {{{1, 0, 0}, {1, 0, 3}, {q("11/10"), 0, 3}, {q("11/10"), 0, 0}}};
  EXPECT_EQ(squared_width(strips), q("1/100"));
  Polygon3 nearly = wall;
  nearly.holes[0][0].z = nearly.holes[0][3].z = q("1/1000000");
  EXPECT_EQ(squared_width(nearly), q("1/1000000000000")) << "this one is";
}

}  // namespace
}  // namespace hottel::polygon_places_test
