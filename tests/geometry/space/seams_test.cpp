#include "geometry/space/scene/seams.h"

#include <gtest/gtest.h>

#include <vector>

namespace hottel::seams_test {
namespace {

using Loop = std::vector<Point3>;

Loop loop(const std::vector<std::pair<int, int>>& points) {
  Loop result;
  for (const auto& [x, y] : points) result.push_back({x, y, x + 2 * y});  // in a plane that leans
  return result;
}

const Loop kSquare = loop({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
const Loop kHole = loop({{1, 1}, {1, 3}, {3, 3}, {3, 1}});
const Loop kOther = loop({{5, 5}, {5, 7}, {7, 7}, {7, 5}});

Loop joined(const std::vector<Loop>& parts) {
  Loop result;
  for (const Loop& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

void expect_opens(const Loop& outline, const Loop& rest, const std::vector<Loop>& holes) {
  Polygon3 polygon{outline};
  EXPECT_TRUE(open_seams(polygon));
  EXPECT_EQ(polygon.points, rest);
  EXPECT_EQ(polygon.holes, holes);
  EXPECT_EQ(polygon_problem(polygon).text, "");
  // The area is what it was.
  EXPECT_EQ(doubled_area(polygon), doubled_area(Polygon3{outline}));
}

TEST(Seams3, AnOutlineThatRunsToItsHoleAndBackHasThatHole) {
  expect_opens(joined({kSquare, {kSquare[0]}, kHole, {kHole[0]}}), kSquare, {kHole});
}

TEST(Seams3, EachOfSeveralHolesHasASeamOfItsOwn) {
  const Loop both = joined({{kSquare[0]},
                            kHole,
                            {kHole[0]},
                            {kSquare[0]},
                            {kSquare[1], kSquare[2]},
                            kOther,
                            {kOther[0], kSquare[2], kSquare[3]}});
  expect_opens(both, kSquare, {kHole, kOther});
}

TEST(Seams3, RunFromHoleToHole_1) {
  // From the corner to the first hole, half around it, on to the second, and back.
  const Loop chain = joined({{kSquare[0], kHole[0], kHole[1], kHole[2]},
                             kOther,
                             {kOther[0], kHole[2], kHole[3]},
                             {kHole[0], kSquare[0]},
                             {kSquare[1], kSquare[2], kSquare[3]}});
  expect_opens(chain, kSquare, {kHole, kOther});
}

TEST(Seams3, MayHaveCornersOnTheirWay_1) {
  const Point3 bend = loop({{1, 0}})[0];
  expect_opens(
      joined({{kSquare[0], bend}, kHole, {kHole[0], bend}, {kSquare[0]}, {kSquare[1], kSquare[2], kSquare[3]}}),
      kSquare, {kHole});
}

TEST(Seams3, TheOutlineBeginsWithTheCornerThatComesFirst_2) {
  const Loop turned = joined({kHole, {kHole[0], kSquare[2], kSquare[3], kSquare[0], kSquare[1], kSquare[2]}});
  expect_opens(turned, {kSquare[2], kSquare[3], kSquare[0], kSquare[1]}, {kHole});
}

TEST(Seams3, LoopsTheSameWayRoundAreNoHoles_3) {
  for (const Loop& outline :
       {joined({kSquare, {kSquare[0]}, {kHole[0], kHole[3], kHole[2], kHole[1]}, {kHole[0]}}),  // twice around
        joined({kSquare, {kSquare[0], loop({{1, 1}})[0]}}),                                     // there and back
        joined({kSquare, {kSquare[0], kHole[0], kHole[2], kHole[0]}}),                          // a slit
        kSquare}) {
    Polygon3 polygon{outline};
    EXPECT_FALSE(open_seams(polygon));
    EXPECT_EQ(polygon, Polygon3{outline});
  }
}

}  // namespace
}  // namespace hottel::seams_test
