#include "tests/oracle/plane/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/oracle/plane/split.h"

namespace hottel::oracle::solids_test {
namespace {

using Points = std::vector<std::pair<int, int>>;
using Edges = std::vector<InputSegment>;

void add(Edges& edges, int group, const Points& points, int back = -1, Behind behind = Behind::kNothingSaid,
         bool closed = true) {
  for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k) {
    const auto &a = points[k], &b = points[(k + 1) % points.size()];
    edges.push_back({a.first, a.second, b.first, b.second, 0, back, group, behind});
  }
}

Points box(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Points room(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }

std::size_t covered(const Edges& edges) {
  std::size_t sides = 0;
  for (const Segment& piece : split(edges).pieces) sides += (piece.left == kCovered) + (piece.right == kCovered);
  return sides;
}

TEST(OracleSolids2, AreClosedOutlinesWithFrontsOutward) {
  Edges edges;
  add(edges, 0, box(0, 0, 1, 1));
  EXPECT_EQ(covered(edges), 4u);
  Edges inward, with_back, open;
  add(inward, 0, room(0, 0, 1, 1));
  EXPECT_EQ(covered(inward), 0u);
  add(with_back, 0, box(0, 0, 1, 1), 0);
  EXPECT_EQ(covered(with_back), 0u);
  add(open, 0, box(0, 0, 1, 1), -1, Behind::kNothingSaid, false);
  EXPECT_EQ(covered(open), 0u);
}

TEST(OracleSolids2, AreNotOutlinesThatWindTwiceOrCrossThemselves) {
  Edges twice, eight;
  add(twice, 0, {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_EQ(covered(twice), 0u);
  add(eight, 0, {{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(covered(eight), 0u);
}

TEST(OracleSolids2, LeaveOutRoomsInThem) {
  Edges edges;
  add(edges, 0, box(0, 0, 4, 4));
  add(edges, 1, room(1, 1, 3, 3));
  EXPECT_EQ(covered(edges), 8u) << "four sides of each look into the walls";
  EXPECT_TRUE(split(edges).has_room);
  Edges partly_outside;
  add(partly_outside, 0, box(0, 0, 4, 4));
  add(partly_outside, 1, room(1, 1, 6, 3));
  EXPECT_FALSE(split(partly_outside).has_room);
}

TEST(OracleSolids2, AreBehindBacksThatBoundARegion) {
  Edges edges;
  add(edges, 0, {{3, 0}, {0, 0}}, -1, Behind::kNothingSaid, false);
  add(edges, 1, {{2, 0}, {2, 1}, {1, 1}, {1, 0}}, -1, Behind::kSolid, false);
  EXPECT_EQ(covered(edges), 4u) << "three sides and the floor between";
  edges.erase(edges.begin());
  EXPECT_EQ(split(edges).unbounded, std::vector<std::size_t>{0});
}

TEST(OracleSolids2, AreTakenBackByOpenAndConflictOnlyWithWhatIsSaid) {
  Edges edges;
  add(edges, 0, box(0, 0, 4, 4), -1, Behind::kOpen);
  EXPECT_EQ(covered(edges), 0u);
  add(edges, 1, box(0, 0, 4, 4));
  EXPECT_EQ(covered(edges), 4u);
  EXPECT_TRUE(split(edges).contradictions.empty());
  for (std::size_t k = 4; k < 8; ++k) edges[k].behind = Behind::kSolid;
  EXPECT_EQ(split(edges).contradictions, (std::set<std::pair<std::size_t, std::size_t>>{{1, 0}}));
}

// The floor of a room, front up, and a box on it: its bottom makes no claim on the lower side of the floor.
TEST(OracleSolids2, SilenceFrontsThatLieUnderAFaceThatLooksIn) {
  Edges edges{{4, 0, 0, 0}};
  add(edges, 0, box(1, 0, 3, 2));
  const Split result = split(edges);
  EXPECT_EQ(result.silent_fronts, 1u);
  for (const Segment& piece : result.pieces)
    if (piece.ay == 0 && piece.by == 0 && piece.ax == 1) {
      EXPECT_EQ(piece.left, kCovered);
      EXPECT_EQ(piece.right, back_label(0));
    }
  edges[0] = {0, 0, 4, 0};  // front down: nothing with a material looks in, both claim the lower side
  EXPECT_EQ(split(edges).silent_fronts, 0u);
}

}  // namespace
}  // namespace hottel::oracle::solids_test
