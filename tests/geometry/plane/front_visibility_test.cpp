#include "geometry/plane/visibility/front_visibility.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/visibility_polygons.h"
#include "io/scene/plane/map_reader.h"
#include "kernel/support/failure.h"

namespace hottel::front_visibility_test {
namespace {

// What the fronts at a point of a map see: the exact area, and the corners.
struct Seen {
  std::optional<Rational> area;
  RoundedPolygon2 polygon;
};
Seen seen(const std::string& map, const Point2& eye, MapSide2 side = MapSide2::kInside) {
  const PreparedScene2 prepared = prepare(parse_map_2(map, "map.wkt", side));
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  VisibilityPolygon2 polygon = visibility_polygon(prepared.arrangement, location, eye);
  keep_fronts(prepared.arrangement, polygon);
  return {polygon.area, rounded_polygon(polygon, true)};
}
Rational area(const std::string& map, const Point2& eye, MapSide2 side = MapSide2::kInside) {
  const Seen found = seen(map, eye, side);
  EXPECT_TRUE(found.area.has_value());
  return found.area.value_or(Rational(-1));
}

const std::string kSquare = "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))";
const std::string kElbow = "POLYGON ((0 0, 4 0, 4 2, 2 2, 2 4, 0 4, 0 0))";

TEST(FrontVisibility2, ARoomIsAllThatItsOutlineSees_1) {
  for (const Point2& eye : {Point2{0, 0}, Point2{5, 5}, Point2{2, 0}, Point2{0, Rational(1, 3)}}) {
    EXPECT_EQ(area(kSquare, eye), 25);
    EXPECT_FALSE(seen(kSquare, eye).polygon.sees_sky());
    EXPECT_GE(seen(kSquare, eye).polygon.exact.size(), 4u);
  }
}

TEST(FrontVisibility2, BothFrontsAtACornerAreLookedFrom_1) {
  EXPECT_EQ(area(kElbow, {2, 2}), 12);
  EXPECT_EQ(area(kElbow, {0, 0}), 12);
  EXPECT_EQ(area(kElbow, {4, 2}), 8);  // along the wall: what lies under it
}

TEST(FrontVisibility2, BeforeTheLineOfAWallThatEndsThere_1) {
  // A wall in the middle of a room of 4 x 4, with its front (the right of its way) up; from its ends and its middle the
  // upper half is seen.
  const std::string room = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)) LINESTRING (3 2, 1 2)";
  for (const Point2& eye : {Point2{3, 2}, Point2{1, 2}, Point2{2, 2}}) EXPECT_EQ(area(room, eye), 8);
}

TEST(FrontVisibility2, TakesNothingAwayFromPointsOnNoPiece_2) {
  EXPECT_EQ(area(kSquare, {1, 1}), 25);
  const Seen outside = seen(kSquare, {7, 7});
  EXPECT_FALSE(outside.area.has_value());
  EXPECT_TRUE(outside.polygon.sees_sky());
}

TEST(FrontVisibility2, TellsNoAreaWhereTheSkyIsSeen_3) {
  const Seen house = seen(kSquare, {5, 2}, MapSide2::kOutside);
  EXPECT_FALSE(house.area.has_value());
  EXPECT_TRUE(house.polygon.sees_sky());
}

TEST(FrontVisibility2, ArcsBoundWhatIsSeenWithinARange) {
  const PreparedScene2 prepared = prepare(parse_map_2(kSquare, "map.wkt"));
  const VisibilityPolygons2 polygons(prepared.arrangement);
  const RoundedPolygon2 quarter = polygons.of({0, 0}, {.range = Rational(1), .fronts_only = true});
  ASSERT_EQ(quarter.corners.size(), 3u);  // the point, and the ends of an arc
  for (const auto& corner : quarter.corners) {
    EXPECT_GE(corner.x, 0);
    EXPECT_GE(corner.y, 0);
  }
}

}  // namespace
}  // namespace hottel::front_visibility_test
