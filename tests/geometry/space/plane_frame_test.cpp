// Planes of space, and points in them.
#include "geometry/space/scene/plane_frame.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/geometry/space/box_scene.h"

namespace hottel::plane_frame_test {
namespace {

const Rational kThird = Rational(1) / 3;

TEST(PlaneFrame3, HasAKeyInCoprimeIntegersThatIsThatOfThePlaneAlone) {
  const PlaneFrame3 frame({{0, 0, kThird}, {1, 0, kThird}, {0, 1, kThird}});
  EXPECT_EQ(frame.key(), (PlaneFrame3::Key{0, 0, 3, 1}));
  // Other points of the plane, the other way round, with a straight corner first.
  EXPECT_EQ(PlaneFrame3({{5, 5, kThird}, {6, 5, kThird}, {7, 5, kThird}, {5, -1, kThird}}).key(), frame.key());
  EXPECT_NE(PlaneFrame3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).key(), frame.key());
  // The first number that is not 0 is positive.
  EXPECT_EQ(PlaneFrame3({{-1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}}).key(), (PlaneFrame3::Key{1, 0, 0, -1}));
  EXPECT_EQ(PlaneFrame3({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).key(), (PlaneFrame3::Key{1, 1, 1, 1}));
  EXPECT_EQ(PlaneFrame3({{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}).key(), (PlaneFrame3::Key{1, 1, 1, 1}));
}

TEST(PlaneFrame3, TellsPlanesApartThatLieNextToEachOther) {
  const Rational least = Rational(1) / (Rational(1) << 200);
  EXPECT_NE(PlaneFrame3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).key(),
            PlaneFrame3({{0, 0, 0}, {1, 0, 0}, {0, 1, least}}).key());
}

TEST(PlaneFrame3, FlatAndPointAreInverse) {
  std::mt19937_64 random(5);
  const auto number = [&]() -> Rational { return Rational(static_cast<long>(random() % 19) - 9, 7); };
  for (int round = 0; round < 300; ++round) {
    std::vector<Point3> p(3);
    for (Point3& q : p) {
      q = {number(), number(), number()};
      for (Rational* c : {&q.x, &q.y, &q.z}) c->canonicalize();
    }
    if (round % 3 == 0) p[2].z = p[1].z = p[0].z;
    if (round % 5 == 0) p[2].x = p[1].x = p[0].x;
    const Vector3 normal = cross(p[1] - p[0], p[2] - p[0]);
    if (normal.is_zero()) continue;
    const PlaneFrame3 frame(p);
    for (const Point3& q : p) {
      EXPECT_EQ(frame.point(frame.flat(q)), q);
      EXPECT_EQ(frame.height(q), 0);
    }
    // Counter-clockwise in (u, v) is counter-clockwise seen from the side of the normal.
    const Vector3 up{Rational(frame.key()[0]), Rational(frame.key()[1]), Rational(frame.key()[2])};
    const Rational turn = doubled_area(frame.flat(p[0]), frame.flat(p[1]), frame.flat(p[2]));
    EXPECT_EQ(sgn(turn), sgn(dot(normal, up)));
    EXPECT_EQ(frame.is_front_up(p), turn > 0);
    const Point3 above{p[0].x + up.x, p[0].y + up.y, p[0].z + up.z};
    EXPECT_EQ(frame.height(above), dot(up, up));
  }
}

TEST(PlaneFrame3, ARegionIsTheOutlineAndTheHoles) {
  Polygon3 window = level(0, 0, 3, 3, 1);
  window.holes.push_back(level(1, 1, 2, 2, 1).points);
  const FlatRegion3 region = PlaneFrame3(window.points).region(window.points, window.holes);
  ASSERT_EQ(region.loops().size(), 2u);
  EXPECT_EQ(region.loops()[0].size(), 4u);
}

TEST(PlaneFrame3, KeysAreInOneOrder) {
  const PlaneFrame3 a(level(0, 0, 1, 1, 5).points), b(level(0, 0, 1, 1, 6).points), like_a(level(3, 3, 4, 4, 5).points);
  const PlaneFrame3 c({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_TRUE(a.precedes(b) != b.precedes(a));
  EXPECT_TRUE(a.precedes(c) != c.precedes(a));
  EXPECT_FALSE(a.precedes(like_a));
  EXPECT_FALSE(like_a.precedes(a));
}

}  // namespace
}  // namespace hottel::plane_frame_test
