#include "tests/oracle/plane/split.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace hottel::oracle::split_test {
namespace {

// (ax, ay, bx, by, left, right), so that sets of pieces can be compared.
using Row = std::tuple<mpq_class, mpq_class, mpq_class, mpq_class, int, int>;

std::set<Row> rows(const std::vector<InputSegment>& edges) {
  std::set<Row> result;
  for (const Segment& s : split(edges).pieces) result.insert({s.ax, s.ay, s.bx, s.by, s.left, s.right});
  return result;
}

TEST(OracleSplit2, CutsCrossingsAtTheRationalPoint) {
  const mpq_class third(1, 3), two_thirds(2, 3);
  // y = 2x from (0,0) and y = 1 - x: they meet in (1/3, 2/3)
  EXPECT_EQ(rows({{0, 0, 1, 2}, {0, 1, 1, 0}}), (std::set<Row>{{0, 0, third, two_thirds, 1, 0},
                                                               {third, two_thirds, 1, 2, 1, 0},
                                                               {0, 1, third, two_thirds, 3, 2},
                                                               {third, two_thirds, 1, 0, 3, 2}}));
}

TEST(OracleSplit2, CutsAtTJunctionsOnly) {
  EXPECT_EQ(rows({{0, 0, 4, 0}, {1, 0, 1, 3}}),
            (std::set<Row>{{0, 0, 1, 0, 1, 0}, {1, 0, 4, 0, 1, 0}, {1, 0, 1, 3, 3, 2}}));
  EXPECT_EQ(rows({{0, 0, 1, 0}, {1, 0, 2, 0}}), (std::set<Row>{{0, 0, 1, 0, 1, 0}, {1, 0, 2, 0, 3, 2}}));
  EXPECT_EQ(rows({{0, 0, 1, 0}, {2, 0, 3, 0}}), (std::set<Row>{{0, 0, 1, 0, 1, 0}, {2, 0, 3, 0, 3, 2}}));
}

TEST(OracleSplit2, TurnsPiecesRoundButKeepsTheSidesOfFaces) {
  EXPECT_EQ(rows({{1, 0, 0, 0}}), (std::set<Row>{{0, 0, 1, 0, 0, 1}}));
}

TEST(OracleSplit2, GivesAnOverlapWithEqualClaimsToTheFirstListed) {
  EXPECT_EQ(rows({{0, 0, 2, 0, 5}, {1, 0, 3, 0, 5}}),
            (std::set<Row>{{0, 0, 1, 0, 1, 0}, {1, 0, 2, 0, 1, 0}, {2, 0, 3, 0, 3, 2}}));
  EXPECT_EQ(rows({{0, 0, 1, 0, 5}, {0, 0, 1, 0, 5}}), rows({{0, 0, 1, 0, 5}}));
}

TEST(OracleSplit2, MakesTwoOpposedEdgesATwoFacedWall) {
  EXPECT_EQ(rows({{0, 0, 1, 0, 5}, {1, 0, 0, 0, 6}}), (std::set<Row>{{0, 0, 1, 0, 2, 0}}));
}

TEST(OracleSplit2, LetsABackClaimOnlyWithAMaterial) {
  // The second edge's front claims the left side; the first edge's back claims it too, or leaves it.
  EXPECT_EQ(rows({{0, 0, 1, 0, 5, 6}, {1, 0, 0, 0, 6}}), (std::set<Row>{{0, 0, 1, 0, 1, 0}}));
  EXPECT_EQ(rows({{0, 0, 1, 0, 5, -1}, {1, 0, 0, 0, 6}}), (std::set<Row>{{0, 0, 1, 0, 2, 0}}));
  // Two black backs: the first listed edge's.
  EXPECT_EQ(rows({{0, 0, 1, 0, 5}, {0, 0, 1, 0, 5}}), (std::set<Row>{{0, 0, 1, 0, 1, 0}}));
}

TEST(OracleSplit2, ReportsClaimsThatDiffer) {
  const Split refused = split({{0, 0, 2, 0, 5}, {1, 0, 3, 0, 6}});
  ASSERT_EQ(refused.conflicts.size(), 1u);
  const Conflict& conflict = refused.conflicts.front();
  EXPECT_EQ(conflict.first, front_label(0));
  EXPECT_EQ(conflict.second, front_label(1));
  EXPECT_EQ(conflict.ax, 1);
  EXPECT_EQ(conflict.bx, 2);
  EXPECT_EQ(split({{0, 0, 1, 0, 5, 6}, {1, 0, 0, 0, 7}}).conflicts.size(), 1u);
  EXPECT_TRUE(split({{0, 0, 1, 0, 5, 6}, {1, 0, 0, 0, 6, 5}}).conflicts.empty());
}

}  // namespace
}  // namespace hottel::oracle::split_test
