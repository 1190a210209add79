#include "tests/oracle/plane/regions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hottel::oracle::regions_test {
namespace {

std::size_t bounded(const Regions& regions) {
  return static_cast<std::size_t>(
      std::count_if(regions.all.begin(), regions.all.end(), [](const Region& region) { return region.is_bounded; }));
}

TEST(OracleRegions2, AreOneAroundPiecesThatCloseNothing) {
  const Regions nothing = regions_of({});
  EXPECT_EQ(nothing.all.size(), 1u);
  const Regions regions = regions_of({{{0, 0}, {0, 2}}, {{0, 1}, {3, 1}}, {{5, 0}, {6, 3}}});
  EXPECT_EQ(regions.all.size(), 1u);
  EXPECT_FALSE(regions.all[0].is_bounded);
}

TEST(OracleRegions2, AreTheInsideAndTheOutsideOfATriangle) {
  const Regions regions = regions_of({{{0, 0}, {2, 1}}, {{0, 0}, {1, 3}}, {{1, 3}, {2, 1}}});
  ASSERT_EQ(regions.all.size(), 2u);
  EXPECT_EQ(bounded(regions), 1u);
  EXPECT_TRUE(regions.all[regions.left[0]].is_bounded);
  EXPECT_TRUE(regions.all[regions.right[1]].is_bounded);
  EXPECT_EQ(regions.left[0], regions.right[1]);
  EXPECT_EQ(regions.right[0], regions.left[1]);
}

TEST(OracleRegions2, PassAroundIslandsAndThroughNoPoint) {
  // A square of 4, one of 1 in the middle, and one of 1 that touches it in the corner (2, 2).
  const Regions regions = regions_of({{{0, 0}, {0, 4}},
                                      {{0, 0}, {4, 0}},
                                      {{0, 4}, {4, 4}},
                                      {{4, 0}, {4, 4}},
                                      {{1, 1}, {1, 2}},
                                      {{1, 1}, {2, 1}},
                                      {{1, 2}, {2, 2}},
                                      {{2, 1}, {2, 2}},
                                      {{2, 2}, {2, 3}},
                                      {{2, 2}, {3, 2}},
                                      {{2, 3}, {3, 3}},
                                      {{3, 2}, {3, 3}}});
  EXPECT_EQ(regions.all.size(), 4u);
  EXPECT_EQ(bounded(regions), 3u);
  EXPECT_EQ(regions.right[0], regions.left[4]) << "what is around the islands is one region";
  EXPECT_NE(regions.right[4], regions.right[8]) << "the islands meet in a point only";
}

}  // namespace
}  // namespace hottel::oracle::regions_test
