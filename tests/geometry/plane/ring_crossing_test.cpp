// Rings that cross themselves: what find_ring_crossing promises, by number.
#include "geometry/plane/arrangement/ring_crossing.h"

#include <gtest/gtest.h>

#include <vector>

namespace hottel::ring_crossing_test {
namespace {

using Ring = std::vector<Point2>;

TEST(RingCrossing, IsFoundWhereTwoSidesCross) {
  const auto crossing = find_ring_crossing({{0, 0}, {4, 0}, {0, 3}, {4, 3}});
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->first, 1u);
  EXPECT_EQ(crossing->second, 3u);
  EXPECT_EQ(crossing->at, (Point2{2, Rational(3, 2)}));
}

TEST(RingCrossing, IsTheFirstByItsSides) {
  const auto crossing = find_ring_crossing({{0, 0}, {9, 0}, {9, 4}, {7, -1}, {5, 4}, {3, -1}, {0, 4}});
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->first, 0u);
  EXPECT_EQ(crossing->second, 2u);
}

TEST(RingCrossing, IsNoneWhereARingTouchesItselfOrRunsBack_1) {
  for (const Ring& ring : {Ring{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, Ring{{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}},
                           Ring{{0, 0}, {2, 1}, {4, 0}, {4, 3}, {2, 1}, {0, 3}},
                           Ring{{0, 0}, {4, 0}, {4, 3}, {6, 3}, {4, 3}, {0, 3}}, Ring{{0, 0}, {1, 0}, {0, 1}}})
    EXPECT_FALSE(find_ring_crossing(ring));
}

TEST(RingCrossing, IsDecidedExactlyForPointsOfAnySize_2) {
  Rational tiny(1), huge(1);
  for (int k = 0; k < 400; ++k) tiny /= 10, huge *= 10;
  EXPECT_FALSE(find_ring_crossing({{0, 0}, {4, 0}, {4, 3}, {2, tiny}, {0, 3}}));
  EXPECT_TRUE(find_ring_crossing({{0, 0}, {4, 0}, {4, 3}, {2, -tiny}, {0, 3}}));
  EXPECT_FALSE(find_ring_crossing({{0, 0}, {huge, 0}, {huge, huge}, {0, huge}}));
  EXPECT_TRUE(find_ring_crossing({{0, 0}, {huge, 0}, {0, huge}, {huge, huge}}));
}

}  // namespace
}  // namespace hottel::ring_crossing_test
