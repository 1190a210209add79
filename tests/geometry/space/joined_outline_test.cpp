// Outlines of joined polygons: what joined_outline.h says of them.
#include "geometry/space/scene/joined_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace hottel::joined_outline_test {
namespace {

using Loop = std::vector<FlatPoint3>;

Loop box(int u0, int v0, int u1, int v1) { return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}}; }

Rational area_of(const std::vector<FlatPart3>& parts) {
  Rational area;
  for (const FlatPart3& part : parts) {
    EXPECT_GT(doubled_area(part.outline), 0);
    area += doubled_area(part.outline);
    for (const Loop& hole : part.holes) {
      EXPECT_LT(doubled_area(hole), 0);
      area += doubled_area(hole);
    }
  }
  return area / 2;
}

TEST(JoinedOutline, OfOnePolygonIsThatPolygon) {
  const auto parts = joined_outline({box(0, 0, 2, 1)});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].outline.size(), 4u);
  EXPECT_TRUE(parts[0].holes.empty());
  EXPECT_EQ(area_of(parts), 2);
}

// Two boxes on the long side of one: the corner between them lies in the middle of that side.
TEST(JoinedOutline, SidesThatMeetAreGone) {
  const auto parts = joined_outline({box(0, 0, 4, 1), box(0, 1, 1, 2), box(1, 1, 4, 2)});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].outline.size(), 4u);
  EXPECT_EQ(area_of(parts), 8);
}

TEST(JoinedOutline, ARingHasAHole) {
  const auto parts = joined_outline({box(0, 0, 3, 1), box(2, 1, 3, 3), box(0, 2, 2, 3), box(0, 1, 1, 2)});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].outline.size(), 4u);
  ASSERT_EQ(parts[0].holes.size(), 1u);
  EXPECT_EQ(parts[0].holes[0].size(), 4u);
  EXPECT_EQ(area_of(parts), 8);
}

TEST(JoinedOutline, WhatMeetsInAPointIsTwoParts) {
  const auto parts = joined_outline({box(0, 0, 1, 1), box(1, 1, 2, 2)});
  ASSERT_EQ(parts.size(), 2u);
  for (const FlatPart3& part : parts) EXPECT_EQ(part.outline.size(), 4u);
}

TEST(JoinedOutline, AnIslandInAHoleIsAPartOfItsOwn) {
  std::vector<Loop> ring{box(0, 0, 5, 1), box(4, 1, 5, 5), box(0, 4, 4, 5), box(0, 1, 1, 4)};
  ring.push_back(box(2, 2, 3, 3));
  const auto parts = joined_outline(ring);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].holes.size() + parts[1].holes.size(), 1u);
  EXPECT_EQ(area_of(parts), 17);
}

// Cells of a lattice, each cut into two triangles: areas are those of the cells, and no loop has straight points.
TEST(JoinedOutline, KeepsTheAreaOfAnyCells) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 300; ++k) {
    std::vector<Loop> triangles;
    int cells = 0;
    for (int u = 0; u < 5; ++u)
      for (int v = 0; v < 5; ++v) {
        if (random() % 2 == 0) continue;
        ++cells;
        const Loop cell = box(u, v, u + 1, v + 1);
        triangles.push_back({cell[0], cell[1], cell[2]});
        triangles.push_back({cell[0], cell[2], cell[3]});
      }
    std::shuffle(triangles.begin(), triangles.end(), random);
    const auto parts = joined_outline(triangles);
    ASSERT_EQ(area_of(parts), cells);
    for (const FlatPart3& part : parts) {
      ASSERT_EQ(without_straight_points(part.outline).size(), part.outline.size());
      for (const Loop& hole : part.holes) ASSERT_EQ(without_straight_points(hole).size(), hole.size());
    }
  }
}

}  // namespace
}  // namespace hottel::joined_outline_test
