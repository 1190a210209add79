// Where points are free to go in space.
#include "viewer/edit/space/placing.h"

#include <gtest/gtest.h>

namespace hottel::placing_test {
namespace {

Point3 point(long x, long y, long z) { return {Rational(x), Rational(y), Rational(z)}; }

// (1) and (2)
TEST(Freedom3, KeepsPointsInTheirPlanesExactly) {
  Freedom3 freedom(point(1, 2, 3));
  EXPECT_EQ(freedom.dimensions(), 3);
  EXPECT_EQ(freedom.rounded({0.126, 0.5, -1}, 2), (Point3{Rational(13, 100), Rational(1, 2), Rational(-1)}));
  const Vector3 slope{1, 2, 7};
  freedom.hold(slope);
  EXPECT_EQ(freedom.dimensions(), 2);
  const Point3 in_plane = freedom.rounded({0.126, 0.5, 9}, 2);
  EXPECT_EQ(dot(slope, in_plane - point(1, 2, 3)), 0);
  EXPECT_EQ(in_plane.x, Rational(13, 100));
  EXPECT_EQ(in_plane.y, Rational(1, 2));
  EXPECT_EQ(dot(slope, freedom.onto(point(5, 5, 5)) - point(1, 2, 3)), 0);
  EXPECT_TRUE(cross(freedom.onto(point(5, 5, 5)) - point(5, 5, 5), slope).is_zero()) << "the nearest";
  EXPECT_FALSE(freedom.take(plane_through(point(9, 9, 9), {2, 4, 14}))) << "parallel";
  EXPECT_TRUE(freedom.take(plane_through(point(0, 0, 1), {0, 0, 1})));
  EXPECT_EQ(freedom.dimensions(), 1);
  const Point3 on_line = freedom.rounded({0.126, 0.5, 9}, 2);
  EXPECT_EQ(on_line.z, 1);
  EXPECT_EQ(dot(slope, on_line - point(1, 2, 3)), 0);
  freedom.hold_on_axis(0);
  EXPECT_EQ(freedom.dimensions(), 0);
}

TEST(Freedom3, HoldsAPointOnAnAxis) {
  Freedom3 freedom(point(1, 2, 3));
  freedom.hold_on_axis(1);
  EXPECT_EQ(freedom.rounded({8, 2.777, 8}, 1), (Point3{1, Rational(14, 5), 3}));
  EXPECT_EQ(freedom.onto(point(7, 5, 7)), point(1, 5, 3)) << "level with that point";
}

TEST(Freedom3, FollowsTheMouse) {
  Pointer3 pointer{.pixel = 0.01};
  const auto look_at = [&](const Direction3& place) { pointer.at = pointer.seen(place); };
  Freedom3 freedom(point(0, 4, 0));
  look_at({1, 4, 1});
  EXPECT_LT(length(freedom.at(pointer) - Direction3{1, 4, 1}), 1e-12);
  freedom.hold({0, 1, 1});
  look_at({1, 3, 1});
  EXPECT_LT(length(freedom.at(pointer) - Direction3{1, 3, 1}), 1e-12) << "the place of the plane that is seen there";
  freedom.hold_on_axis(0);
  look_at({2, 4, 0.5});
  EXPECT_LT(length(freedom.at(pointer) - Direction3{2, 4, 0}), 0.1);
}

}  // namespace
}  // namespace hottel::placing_test
