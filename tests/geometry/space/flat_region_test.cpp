// Regions of a plane: what is inside, on the border, and in common.
#include "geometry/space/scene/flat_region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hottel::flat_region_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Loop = std::vector<FlatPoint3>;

const Rational kHalf = Rational(1) / 2;

Loop square(const Rational& u0, const Rational& v0, const Rational& u1, const Rational& v1) {
  return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

Rational doubled_area_of(const Loop& loop) {
  Rational sum;
  for (std::size_t k = 2; k < loop.size(); ++k) sum += doubled_area(loop[0], loop[k - 1], loop[k]);
  return sum;
}

TEST(FlatRegion3, DoubledAreasArePositiveCounterClockwise) {
  EXPECT_EQ(doubled_area(FlatPoint3{0, 0}, {2, 0}, {0, 3}), 6);
  EXPECT_EQ(doubled_area(FlatPoint3{0, 0}, {0, 3}, {2, 0}), -6);
  EXPECT_EQ(doubled_area(FlatPoint3{0, 0}, {1, 1}, {2, 2}), 0);
}

TEST(FlatRegion3, IsWhatARayLeavesAcrossAnOddNumberOfSides) {
  const FlatRegion3 frame({square(0, 0, 4, 4), square(1, 1, 3, 3)});
  EXPECT_TRUE(frame.contains({kHalf, kHalf}));
  EXPECT_TRUE(frame.contains({kHalf, 1}));  // a ray runs through corners of the hole
  EXPECT_TRUE(frame.contains({kHalf, 3}));
  EXPECT_FALSE(frame.contains({2, 2}));
  EXPECT_FALSE(frame.contains({5, 1}));
  EXPECT_FALSE(frame.contains({-1, 1}));
  EXPECT_FALSE(frame.contains({-1, 0}));  // along a side
  EXPECT_FALSE(frame.contains({2, 5}));
  EXPECT_FALSE(FlatRegion3().contains({0, 0}));
}

TEST(FlatRegion3, BordersAreThoseOfAllLoops) {
  const FlatRegion3 frame({square(0, 0, 4, 4), square(1, 1, 3, 3)});
  EXPECT_TRUE(frame.is_on_border({0, 0}));
  EXPECT_TRUE(frame.is_on_border({4, kHalf}));
  EXPECT_TRUE(frame.is_on_border({2, 3}));
  EXPECT_FALSE(frame.is_on_border({kHalf, kHalf}));
  EXPECT_FALSE(frame.is_on_border({5, 0}));  // on the line of a side
  std::vector<FlatSegment3> sides;
  frame.append_sides(sides);
  EXPECT_EQ(sides.size(), 8u);
}

TEST(FlatRegion3, MayMeetWhereClosedBoxesDo) {
  const FlatRegion3 a({square(0, 0, 1, 1)}), b({square(1, 1, 2, 2)}), c({square(1 + kHalf, 0, 2, 1)});
  EXPECT_TRUE(a.may_meet(b));
  EXPECT_FALSE(a.may_meet(c));
  EXPECT_FALSE(c.may_meet(a));
}

TEST(CommonPart, IsThatOfTwoConvexPolygons) {
  EXPECT_EQ(doubled_area_of(common_part(square(0, 0, 2, 2), square(1, 1, 3, 3))), 2);
  EXPECT_EQ(common_part(square(0, 0, 2, 2), square(0, 0, 2, 2)).size(), 4u);
  EXPECT_THAT(common_part(square(0, 0, 1, 1), square(1, 0, 2, 1)), IsEmpty());  // a side
  EXPECT_THAT(common_part(square(0, 0, 1, 1), square(1, 1, 2, 2)), IsEmpty());  // a corner
  EXPECT_THAT(common_part(square(0, 0, 1, 1), square(2, 2, 3, 3)), IsEmpty());
  EXPECT_EQ(doubled_area_of(common_part(square(0, 0, 3, 3), square(1, 1, 2, 2))), 2);
  // No three points in a row are on one line.
  EXPECT_EQ(common_part(square(0, 0, 2, 2), {{0, 0}, {4, 0}, {4, 4}}).size(), 3u);
}

TEST(CommonPart, IsTheSameFromBothSides) {
  std::mt19937_64 random(11);
  const auto number = [&] { return static_cast<long>(random() % 6); };
  int met = 0;
  for (int round = 0; round < 400; ++round) {
    Loop a, b;
    for (Loop* loop : {&a, &b}) {
      for (int k = 0; k < 3; ++k) {
        const long u = number(), v = number();
        loop->push_back({u, v});
      }
      if (doubled_area_of(*loop) < 0) std::reverse(loop->begin(), loop->end());
    }
    if (doubled_area_of(a) == 0 || doubled_area_of(b) == 0) continue;
    const Loop ab = common_part(a, b);
    EXPECT_EQ(doubled_area_of(ab), doubled_area_of(common_part(b, a)));
    EXPECT_EQ(!ab.empty(), enters(a, b));
    EXPECT_EQ(!ab.empty(), enters(b, a));
    met += ab.empty() ? 0 : 1;
  }
  EXPECT_GT(met, 50);
}

TEST(Enters, IsTrueOfASegmentThatHasAPointWithin) {
  const Loop unit = square(0, 0, 2, 2);
  EXPECT_TRUE(enters(unit, {{-1, 1}, {3, 1}}));
  EXPECT_TRUE(enters(unit, {{kHalf, kHalf}, {1, 1}}));
  EXPECT_TRUE(enters(unit, {{0, 0}, {2, 2}}));
  EXPECT_FALSE(enters(unit, {{0, 0}, {2, 0}}));    // a side
  EXPECT_FALSE(enters(unit, {{-1, 1}, {0, 1}}));   // it ends on the border
  EXPECT_FALSE(enters(unit, {{1, -1}, {-1, 1}}));  // it touches a corner
  EXPECT_FALSE(enters(unit, {{3, 0}, {3, 2}}));
}

TEST(WithoutStraightPoints, LeavesCornersOnly) {
  EXPECT_THAT(without_straight_points({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}}),
              ElementsAre(FlatPoint3{0, 0}, FlatPoint3{2, 0}, FlatPoint3{2, 2}));
}

}  // namespace
}  // namespace hottel::flat_region_test
