// Degenerate scenes of the plane with known exact answers. All M are twice the exchange measure: M = 2 A F.
#include <gtest/gtest.h>

#include "tests/oracle/laws_2.h"

namespace hottel::oracle {
namespace {

using Edges = std::vector<InputSegment>;

// Asserts the laws of every scene, and returns its measures.
ExactMeasures checked(const Edges& edges, double tolerance = 1e-11) {
  const Split cut = split(edges);
  EXPECT_TRUE(cut.conflicts.empty());
  EXPECT_EQ(broken_integer_closure(cut.pieces), "");
  EXPECT_EQ(broken_closure(cut.pieces), "");
  EXPECT_EQ(broken_positivity(cut.pieces), "");
  if (tolerance > 0) {
    EXPECT_EQ(broken_sweep(cut.pieces, tolerance), "");
  }
  return exact_measures(cut.pieces);
}

constexpr double kNoSweep = 0;  // for scenes beyond the resolution of doubles

mpq_class power_of_two(int exponent) {
  mpq_class result = 1;
  if (exponent >= 0) return result << static_cast<unsigned>(exponent);
  return result >> static_cast<unsigned>(-exponent);
}

Edges in_room(const Edges& more, const mpq_class& size = 4) {
  Edges edges = room(size);
  edges.insert(edges.end(), more.begin(), more.end());
  return edges;
}

constexpr int kFirst = 8, kSecond = 10, kThird = 12;  // fronts of what comes after the room; backs are one more

std::string text(const ExactMeasures& measures, int f, int g) { return measure(measures, f, g).to_string(); }

TEST(OracleCatalogue2, StripsBehindAStripExchangeWhatPassesBesideIt) {
  // Worked by strings: two bundles of measure sqrt(5) - 2 each.
  const ExactMeasures m = checked({{1, 0, -1, 0}, {-1, 2, 1, 2}, {mpq_class(-1, 2), 1, mpq_class(1, 2), 1}});
  EXPECT_EQ(text(m, 0, 2), "-4 + 2*sqrt(5)");
}

TEST(OracleCatalogue2, BlockerAlongABitangentHidesOnlyWhatItCovers) {  // 1
  const ExactMeasures m = checked(in_room({{1, 1, 2, 2}}));
  EXPECT_EQ(measure(m, kRoomBottom, kRoomTop), ExactSum({{1, 2}, {2, 8}, {1, 10}, {-8, 1}}));
  EXPECT_EQ(text(m, kRoomBottom, kRoomRight), "8 - 4*sqrt(2)");
  EXPECT_EQ(text(m, kRoomBottom, kRoomLeft), "8 - 2*sqrt(10)");
}

TEST(OracleCatalogue2, CollinearBlockersNeitherLeakNorLose) {  // 2
  const mpq_class half(1, 2);
  const ExactMeasures m = checked(in_room({{1, 1, 2, 2}, {2, 2, 2 + half, 2 + half}, {3, 3, 3 + half, 3 + half}}));
  EXPECT_EQ(text(m, kRoomBottom, kRoomRight), "8 - 4*sqrt(2)");
  EXPECT_EQ(text(m, kRoomTop, kRoomLeft), "8 - 4*sqrt(2)");
  // By the symmetry about the diagonal.
  EXPECT_EQ(measure(m, kRoomBottom, kRoomTop), measure(m, kRoomLeft, kRoomRight));
  EXPECT_EQ(measure(m, kRoomBottom, kFirst), measure(m, kRoomLeft, kFirst + 1));
}

TEST(OracleCatalogue2, GrazingTipsAreContinuousInTheirPlaces) {  // 3
  // Fins from floor and ceiling whose tips lie on y = x/2 + 1.
  const auto fins = [](const mpq_class& lift) {
    return in_room({{1, 0, 1, mpq_class(3, 2)}, {2, 4, 2, 2 + lift}, {3, 0, 3, mpq_class(5, 2)}});
  };
  const ExactMeasures grazing = checked(fins(0)), lifted = checked(fins(power_of_two(-30)), 1e-8);
  for (const auto& [pair, sum] : lifted)
    EXPECT_NEAR(sum.to_double(), measure(grazing, pair.first, pair.second).to_double(), 1e-8);
}

TEST(OracleCatalogue2, TipsThatTouchLetNothingThrough) {  // 4
  const ExactMeasures m = checked(in_room({{0, 2, 2, 2}, {2, 2, 4, 2}}));
  EXPECT_FALSE(m.contains({kRoomTop, kRoomBottom}));
  EXPECT_EQ(text(m, kRoomBottom, kRoomRight), "6 - 2*sqrt(5)");
  EXPECT_EQ(text(m, kRoomBottom, kFirst), "-2 + 2*sqrt(5)");
  EXPECT_EQ(text(m, kRoomBottom, kSecond), "-2 + 2*sqrt(5)");
}

TEST(OracleCatalogue2, CrackLetsThroughWhatItsStringsSay) {  // 5
  for (const auto& [exponent, factor] :
       {std::pair(-10, "1.7261241293054540646e-4"), std::pair(-50, "1.5700924586837748851e-16")}) {
    const mpq_class d = power_of_two(exponent);
    const ExactMeasures m = checked(in_room({{0, 2, 2, 2}, {2 + d, 2, 4, 2}}), exponent < -20 ? kNoSweep : 1e-11);
    const ExactSum through = measure(m, kRoomBottom, kRoomTop);
    EXPECT_EQ(through, ExactSum({{2, 8}, {-2, 4 + (2 - d) * (2 - d)}}));
    const mpf_class expected(factor, 256);
    EXPECT_LT(abs(through.value(512) / 8 - expected), expected * 1e-18);
  }
}

TEST(OracleCatalogue2, PartitionEndingOnWallsClosesTheRoom) {  // 6
  const ExactMeasures m = checked(in_room({{1, 0, 3, 4}}));
  EXPECT_FALSE(m.contains({kRoomLeft, kRoomRight}));
  EXPECT_EQ(text(m, kRoomLeft, kFirst + 1), "1 + 1*sqrt(17)");
}

TEST(OracleCatalogue2, FinOnAnEdgeEqualsTheEdgeCutThere) {  // 7
  Edges edges{{0, 0, 6, 3}, {2, 1, 1, 4}};
  for (const InputSegment& s : {InputSegment{-1, -1, -1, 5}, {-1, 5, 7, 5}, {7, 5, 7, -1}, {7, -1, -1, -1}})
    edges.push_back(s);
  const ExactMeasures cut = checked(edges);
  std::vector<Segment> whole;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const InputSegment& s = edges[i];
    whole.push_back({s.ax, s.ay, s.bx, s.by, back_label(i), front_label(i)});
  }
  EXPECT_EQ(exact_measures(whole), cut);
  EXPECT_EQ(broken_integer_closure(whole), "");
  // The wall's upper side sees both sides of the fin: cut there, each half sees its own side only.
  constexpr int kUpperHalf = 100;
  std::vector<Segment> halves = split(edges).pieces;
  for (Segment& piece : halves)
    if (piece.left == back_label(0) && piece.ax == 2) piece.left = kUpperHalf;
  const ExactMeasures apart = exact_measures(halves);
  EXPECT_TRUE(apart.contains({back_label(0), back_label(1)}));
  EXPECT_TRUE(apart.contains({front_label(1), kUpperHalf}));
  EXPECT_FALSE(apart.contains({back_label(0), front_label(1)}));
  EXPECT_FALSE(apart.contains({back_label(1), kUpperHalf}));
  EXPECT_FALSE(apart.contains({back_label(0), kUpperHalf}));
}

TEST(OracleCatalogue2, TipThatMissesAnEdgeLetsALittleThrough) {  // 8
  const mpq_class d = power_of_two(-50);
  const ExactMeasures apart = checked(in_room({{2, d, 2, 4}}), kNoSweep);
  EXPECT_GT(measure(apart, kRoomLeft, kRoomRight).value(512), 0);
  EXPECT_LT(measure(apart, kRoomLeft, kRoomRight).to_double(), 1e-14);
  EXPECT_FALSE(checked(in_room({{2, 0, 2, 4}})).contains({kRoomLeft, kRoomRight}));
  EXPECT_FALSE(checked(in_room({{2, -d, 2, 4}}), kNoSweep).contains({kRoomLeft, kRoomRight}));
}

Edges box(int low, int high) {  // fronts outside
  return {{low, low, high, low}, {high, low, high, high}, {high, high, low, high}, {low, high, low, low}};
}

TEST(OracleCatalogue2, BoxesTouchingInAPointHaveNoGapBetweenThem) {  // 9
  Edges edges = in_room(box(2, 4), 8);
  for (const InputSegment& s : box(4, 6)) edges.push_back(s);
  const ExactMeasures m = checked(edges);
  const int lower_right = kSecond, lower_top = kThird, upper_bottom = kFirst + 8, upper_left = kFirst + 14;
  EXPECT_FALSE(m.contains({lower_top, upper_bottom}));
  EXPECT_FALSE(m.contains({lower_right, upper_left}));
  EXPECT_EQ(text(m, lower_top, upper_left), "4 - 2*sqrt(2)");
  EXPECT_EQ(text(m, lower_right, upper_bottom), "4 - 2*sqrt(2)");
  EXPECT_EQ(measure(m, kRoomLeft, kRoomTop), measure(m, kRoomRight, kRoomBottom));
}

TEST(OracleCatalogue2, FloorUnderABoxSeesTheInsideOfTheBoxOnly) {  // 10
  // The floor in three parts; a box of width 2 and height 1 on the middle one.
  const Edges edges{{0, 0, 0, 4}, {0, 4, 4, 4}, {4, 4, 4, 0}, {4, 0, 3, 0}, {3, 0, 1, 0},
                    {1, 0, 0, 0}, {1, 0, 3, 0}, {3, 0, 3, 1}, {3, 1, 1, 1}, {1, 1, 1, 0}};
  const ExactMeasures m = checked(edges);
  const int floor = front_label(4);
  EXPECT_EQ(text(m, floor, back_label(8)), "-2 + 2*sqrt(5)");
  EXPECT_EQ(text(m, floor, back_label(7)), "3 - 1*sqrt(5)");
  EXPECT_EQ(text(m, floor, back_label(9)), "3 - 1*sqrt(5)");
  for (const auto& [pair, sum] : m) {
    if (pair.first != floor && pair.second != floor) continue;
    const int other = pair.first == floor ? pair.second : pair.first;
    EXPECT_TRUE(other == back_label(7) || other == back_label(8) || other == back_label(9)) << other;
  }
}

TEST(OracleCatalogue2, RepeatedEdgesChangeNothing) {  // 11
  const Edges once = in_room({{1, 1, 3, 2}}), twice = in_room({{1, 1, 3, 2}, {1, 1, 3, 2}});
  EXPECT_EQ(checked(twice), checked(once));
}

TEST(OracleCatalogue2, OppositeEdgesAreATwoFacedWall) {  // 11
  const ExactMeasures one = checked(in_room({{1, 1, 3, 2}})), two = checked(in_room({{1, 1, 3, 2}, {3, 2, 1, 1, 0}}));
  for (const int wall : {kRoomLeft, kRoomTop, kRoomRight, kRoomBottom}) {
    EXPECT_EQ(measure(two, kFirst, wall), measure(one, kFirst, wall));
    EXPECT_EQ(measure(two, kSecond, wall), measure(one, kFirst + 1, wall));
  }
}

TEST(OracleCatalogue2, NearPlatesExchangeAllButAnEdgeEffect) {  // 14
  const mpq_class d(1, 1000000000);
  const ExactMeasures m = checked({{1, 0, 0, 0}, {0, d, 1, d}});
  EXPECT_EQ(measure(m, 0, 2), ExactSum({{2, 1 + d * d}, {-2 * d, 1}}));
}

TEST(OracleCatalogue2, NeedleWedgeExchangesAllButItsMouth) {  // 15
  const mpq_class d(1, 1000000000);
  const ExactMeasures m = checked({{1, 0, 0, 0}, {0, 0, 1, d}});
  EXPECT_EQ(measure(m, 0, 2), ExactSum({{1, 1}, {1, 1 + d * d}, {-d, 1}}));
}

TEST(OracleCatalogue2, SliverTriangleSharesItsBaseBetweenItsSides) {  // 16
  const mpq_class h(1, 1000000000000), half(1, 2);
  const ExactMeasures m = checked({{1, 0, 0, 0}, {0, 0, half, h}, {half, h, 1, 0}}, 1e-10);
  EXPECT_EQ(text(m, 0, 2), "1");
  EXPECT_EQ(text(m, 0, 4), "1");
}

TEST(OracleCatalogue2, CornerHalvesTheViewInTheLimit) {  // 20
  // F of a floor element of length e to the wall above its corner: (e + 4 - sqrt(e^2 + 16)) / (2 e) -> 1/2.
  const mpq_class e = power_of_two(-30);
  const ExactMeasures m = checked({{e, 0, 0, 0}, {0, 0, 0, 4}, {4, 0, e, 0}}, 1e-10);
  EXPECT_EQ(measure(m, 0, 2), ExactSum({{e + 4, 1}, {-1, e * e + 16}}));
  EXPECT_NEAR(measure(m, 0, 2).to_double() / (2 * e.get_d()), 0.5, 1e-9);
}

TEST(OracleCatalogue2, RightAngleCanLieBetweenTwoDoubles) {  // 24b
  const mpq_class length = power_of_two(55), height = power_of_two(108) - 1;
  const auto wedge = [&](const mpq_class& h) {
    return measure(checked({{length, 0, 0, 0}, {0, 0, 0, h}}, kNoSweep), 0, 2);
  };
  const ExactSum tie({{length - 2, 1}});  // F = M / 2^56 = 1/2 - 2^-55
  EXPECT_EQ(wedge(height).to_string(), tie.to_string());
  EXPECT_LT(wedge(height - 1).value(1024), tie.value(1024));
  EXPECT_GT(wedge(height + 1).value(1024), tie.value(1024));
}

TEST(OracleCatalogue2, OpenSceneLosesTheRestToTheSky) {  // 25
  const ExactMeasures m = checked({{1, 0, 0, 0}, {0, 1, 1, 1}});
  EXPECT_EQ(text(m, 0, 2), "-2 + 2*sqrt(2)");
  EXPECT_EQ(text(m, 0, kInfinity), "4 - 2*sqrt(2)");
  EXPECT_EQ(text(m, 1, kInfinity), "2");
}

TEST(OracleCatalogue2, ElementsAddUpToTheirWall) {  // 26
  const Edges blocker{{1, 1, 2, 3}, {mpq_class(5, 2), 1, 3, 1}};
  const ExactMeasures whole = checked(in_room(blocker));
  Edges edges = in_room(blocker);
  edges[3] = {4, 0, mpq_class(10, 3), 0};
  edges.push_back({mpq_class(10, 3), 0, 1, 0});
  edges.push_back({1, 0, 0, 0});
  const ExactMeasures parts = checked(edges);
  for (int g : {kRoomLeft, kRoomTop, kRoomRight, kFirst, kFirst + 1, kSecond, kSecond + 1}) {
    ExactSum sum = measure(parts, kRoomBottom, g);
    sum += measure(parts, front_label(6), g);
    sum += measure(parts, front_label(7), g);
    EXPECT_EQ(sum, measure(whole, kRoomBottom, g)) << g;
  }
}

TEST(OracleCatalogue2, CrossingEdgesAreFourThatMeet) {  // 27
  const Edges cross = in_room({{0, 0, 4, 4}, {0, 4, 4, 0}});
  EXPECT_EQ(split(cross).pieces.size(), 8u);
  const ExactMeasures m = checked(cross);
  // Each room side is the base of a triangle 4, sqrt(8), sqrt(8) with half of either diagonal.
  EXPECT_EQ(text(m, kRoomLeft, kFirst + 1), "4");
  EXPECT_EQ(text(m, kRoomLeft, kSecond), "4");
  EXPECT_FALSE(m.contains({kRoomLeft, kRoomTop}));
}

TEST(OracleCatalogue2, BoxInABoxIsDark) {  // 21
  const ExactMeasures m = checked(in_room({{1, 1, 1, 3}, {1, 3, 3, 3}, {3, 3, 3, 1}, {3, 1, 1, 1}, {1, 2, 2, 2}}));
  for (const auto& entry : m) {
    const auto is_inside = [](int label) { return (label >= kFirst && label % 2 == 0) || label >= kFirst + 8; };
    EXPECT_EQ(is_inside(entry.first.first), is_inside(entry.first.second));
  }
}

TEST(OracleCatalogue2, SmallestExchangesSurviveAmongNearlyCollinearPoints) {
  // Points of Kettner, Mehlhorn, Pion, Schirra and Yap, read as exact doubles.
  const auto exact = [](double x) { return mpq_class(x); };
  const mpq_class p4x = exact(0.50000000000001621), p4y = exact(0.50000000000001243), p1x = exact(7.3000000000000194),
                  p1y = exact(7.3000000000000167), p2x = exact(24.000000000000068), p2y = exact(24.000000000000071),
                  p3x = exact(24.00000000000005), p3y = exact(24.000000000000053);
  const ExactMeasures m = checked({{-10, -10, -10, 40},
                                   {-10, 40, 40, 40},
                                   {40, 40, 40, -10},
                                   {40, -10, -10, -10},
                                   {p4x, p4y, p1x, p1y},
                                   {p3x, p3y, 30, 20},
                                   {p2x, p2y, 20, 30}},
                                  kNoSweep);
  mpf_class smallest(1, 512);
  for (const auto& [pair, sum] : m) smallest = std::min(smallest, sum.value(512));
  EXPECT_NEAR(smallest.get_d(), 3.732e-32, 0.001e-32);
}

}  // namespace
}  // namespace hottel::oracle
