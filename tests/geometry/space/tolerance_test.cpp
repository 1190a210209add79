// What the tolerance of view factors in space is relative to, and that ordinary scenes are within it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "box_scene.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/exchange/pair_shares.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "geometry/space/vectors/integer_reals.h"
#include "kernel/support/failure.h"
#include "kernel/wide_real.h"

namespace hottel::tolerance_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Rational tenth_to(int k) {
  return Rational(1) / Rational(Integer("1" + std::string(static_cast<std::size_t>(k), '0')));
}

// What rows came to.
struct RowsOf3 {
  std::map<std::pair<std::string, std::string>, PairSum3> pairs;  // areas in squares of the doubles of vertices
  std::map<std::string, double> areas;
  double defect = 0;      // the largest |row sum - 1|
  double beyond = 0;      // the largest that is not told by the errors of the row
  double most_error = 0;  // of a pair, over its smaller area
};

// REQUIRES that all pairs with the sky can be measured.
RowsOf3 rows_of(const Scene3& scene, double tolerance) {
  const PreparedScene3 prepared = prepare(scene);
  ExchangeRows3 rows(prepared, {.tolerance = tolerance});
  rows.add_all();
  const ElementTable3& table = rows.table();
  std::vector<double> sum(table.count(), -1), error(table.count(), 0);
  RowsOf3 result;
  const auto name = [&](std::uint32_t i) { return i == table.sky() ? std::string("sky") : table.elements()[i].name; };
  for (const PairSum3& pair : rows.pairs()) {
    result.pairs.emplace(std::pair(name(pair.i), name(pair.j)), pair);
    double least = table.extent(pair.i).value;
    for (const std::uint32_t from : {pair.i, pair.j}) {
      if (from == table.sky() || (from == pair.j && pair.i == pair.j)) continue;
      const double area = table.extent(from).value;
      least = std::min(least, area);
      sum[from] += pair.measure / area;
      error[from] += pair.error / area;
    }
    result.most_error = std::max(result.most_error, pair.error / least);
    EXPECT_LE(pair.bounds.lower, pair.measure);
    EXPECT_LE(pair.measure, pair.bounds.upper);
  }
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    result.areas[name(i)] = table.extent(i).value;
    if (!table.has_row(i)) continue;
    result.defect = std::max(result.defect, std::fabs(sum[i]));
    result.beyond = std::max(result.beyond, std::fabs(sum[i]) - error[i]);
  }
  return result;
}

// A room of 6 x 6 x 6 with two boxes along its south wall, a gap between them.
BoxScene3 two_boxes_along_a_wall(const Rational& gap) {
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {6, 6, 6}, true);
  scene.box("a", {1, 0, 0}, {2, 1, 1});
  scene.box("b", {2 + gap, 0, 0}, {3, 1, 2});
  return scene;
}

// The same, and all that is nearly flush off by the gap: lifted, off the wall, wider than what it stands on.
BoxScene3 nearly_flush_boxes(const Rational& gap) {
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {6, 6, 6}, true);
  scene.box("a", {1, gap, gap}, {2, 1, 1});
  scene.box("b", {2 + gap, 0, 0}, {3, 1 + gap, 2});
  scene.box("c", {gap, 2, 0}, {1, 3, 1});
  return scene;
}

TEST(Tolerance3, SliversThatCoversCutOffAreNotHeldToTheirOwnAreas) {
  const RowsOf3 closed = rows_of(two_boxes_along_a_wall(0), 1e-12);
  const auto floor_and_wall = std::pair<std::string, std::string>("room bottom", "room south");
  const auto factor = [&](const RowsOf3& rows) {
    return rows.pairs.at(floor_and_wall).measure / rows.areas.at("room bottom");
  };
  for (const int k : {3, 6, 9, 15}) {
    const RowsOf3 loose = rows_of(two_boxes_along_a_wall(tenth_to(k)), 1e-9);
    const RowsOf3 tight = rows_of(two_boxes_along_a_wall(tenth_to(k)), 1e-12);
    EXPECT_LE(loose.beyond, 1e-14) << k;
    EXPECT_LE(loose.most_error, 1e-9) << k;
    EXPECT_LE(tight.beyond, 1e-14) << k;
    EXPECT_LE(tight.most_error, 1e-12) << k;
    EXPECT_LE(tight.defect, 1e-11) << k;
    EXPECT_NEAR(factor(loose), factor(tight), 1e-9) << k;
    // Of areas of 36, 1 x 1 at the foot of the wall and 1 x the gap: what passes it is at most as much of both.
    EXPECT_NEAR(factor(tight), factor(closed), std::pow(10.0, -k) / 16 + 1e-11) << k;
    // The boxes see each other across the gap, but for what leaves by its rims.
    const PairSum3& across = tight.pairs.at({"a east", "b west"});
    EXPECT_NEAR(across.measure / tight.areas.at("a east"), 1, 4 * std::pow(10.0, -k) + 1e-12) << k;
  }
}

TEST(Tolerance3, BoxesThatAreNearlyFlushAreMeasured) {
  for (const int k : {4, 13})
    for (const double tolerance : {1e-9, 1e-12}) {
      const RowsOf3 rows = rows_of(nearly_flush_boxes(tenth_to(k)), tolerance);
      EXPECT_LE(rows.beyond, 1e-14) << k;
      EXPECT_LE(rows.most_error, tolerance) << k;
      EXPECT_LE(rows.defect, 10 * tolerance) << k;
    }
}

void expect_closed(const BoxScene3& scene, double tolerance) {
  const RowsOf3 rows = rows_of(scene, tolerance);
  EXPECT_LE(rows.beyond, 1e-14) << tolerance;
  EXPECT_LE(rows.most_error, tolerance) << tolerance;
  EXPECT_LE(rows.defect, 10 * tolerance) << tolerance;
}

Rational two_to_minus(unsigned k) { return Rational(1) / Rational(Integer(1) << k); }

// What passes a gap, or what something far away gets, is less than the tolerance long before doubles end.
TEST(Tolerance3, GapsAndDistancesBeyondDigitsOfAnyKindAreMeasured) {
  for (const int k : {60, 180, 280}) expect_closed(two_boxes_along_a_wall(tenth_to(k)), 1e-9);
  for (const int k : {30, 90, 140}) {
    BoxScene3 scene;
    const Rational far = 1 / tenth_to(k);
    scene.box("a", {0, 0, 0}, {1, 1, 1});
    scene.box("b", {far, 0, 0}, {far + 1, 1, 2});
    const RowsOf3 rows = rows_of(scene, 1e-9);
    EXPECT_LE(rows.beyond, 1e-14) << k;
    const PairSum3& facing = rows.pairs.at({"a east", "b west"});
    const double most = rows.areas.at("a east") * std::pow(10.0, -k);
    EXPECT_LE(facing.bounds.upper, std::max(most, std::numeric_limits<double>::denorm_min())) << k;
    EXPECT_GT(facing.measure, 0) << k;
  }
}

// The long edges of a needle pass what is narrower than a double is told by: between two parts of them nothing is left
// out.
TEST(Tolerance3, NeedlesBesideBoxesWithAStepOfTwoToMinus41AreMeasured) {
  const Rational step = two_to_minus(41), tip = tenth_to(14) * 5;
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {Rational(57, 10), Rational(57, 10), Rational(5, 2)}, true);
  scene.box("a", {step, Rational(87, 20), 0}, {Rational(2, 5) + step, Rational(53, 10), Rational(11, 10)});
  scene.box("b", {0, Rational(19, 5), 0}, {Rational(2, 5), Rational(87, 20), 2});
  const Rational height(13, 20);
  scene.polygon("needle",
                {{{Rational(1, 4), tip, height},
                  {Rational(1, 4), tip, height + two_to_minus(33)},
                  {Rational(19, 20), Rational(1, 4) + tip, height}}},
                0, 0);
  for (const double tolerance : {1e-9, 1e-12}) expect_closed(scene, tolerance);
}

// A strip of 2^-30 below a plate of 9e-16: what a wall sees of it changes twice within 3e-16 of the wall's edge.
TEST(Tolerance3, NarrowStripsBelowThinPlatesAreMeasured) {
  const Rational thin = Rational(Integer("4503599627370501"), Integer("5629499534213120"));
  BoxScene3 scene;
  scene.box("room", {0, 0, 0}, {Rational(26, 5), Rational(27, 10), Rational(13, 5)}, true);
  scene.box("plate", {Rational(13, 20), Rational(7, 10), Rational(4, 5)}, {Rational(31, 20), Rational(29, 20), thin});
  const Rational x(7, 10), y(3, 4), top = Rational(8000001, 10000000), width = two_to_minus(30);
  scene.polygon("strip", {{{x, y, top}, {x, y, 0}, {x + width, y + width, 0}, {x + width, y + width, top}}}, 0, 0);
  for (const double tolerance : {1e-9, 1e-12}) expect_closed(scene, tolerance);
}

TEST(Tolerance3, NeedlesBehindABoxAreMeasured) {
  for (const int k : {3, 6, 9}) {
    BoxScene3 scene;
    scene.box("room", {0, 0, 0}, {6, 6, 6}, true);
    scene.box("needle", {2, 2, 1}, {2 + tenth_to(k), 3, 2});
    scene.box("box", {3, 3, 0}, {4, 4, 4});
    const RowsOf3 rows = rows_of(scene, 1e-12);
    EXPECT_LE(rows.beyond, 1e-14) << k;
    EXPECT_LE(rows.most_error, 1e-12) << k;
    EXPECT_LE(rows.defect, 1e-11) << k;
  }
}

// A wall that six digits leave bent, so that it is two triangles, and a box whose corner all but touches it.
// Two sheets that nearly touch along a line: at 1e-12 ends of pieces were told well enough for what they exchange, and
// too badly for the residual, though at 1e-13 all was well.
TEST(Tolerance3, SheetsThatNearlyTouchAreMeasuredAtEachTolerance) {
  const Rational hair = two_to_minus(22), high = Rational(1, 8) - hair, far = 2 + two_to_minus(18);
  BoxScene3 scene;
  scene.polygon("a", {{{0, 2, high}, {1, 2, high}, {0, 2, -hair}}}, 0, 0);
  scene.polygon("b", {{{0, 0, 0}, {0, 0, -hair}, {0, 1, 0}}}, 0, 0);
  scene.polygon("c", {{{0, 0, 0}, {2, 3, 0}, {0, 2, 0}}}, 0, 0);
  scene.polygon("d", {{{0, 0, 0}, {1, far, 0}, {0, 2, -hair}}}, 0, 0);
  for (const double tolerance : {1e-11, 7e-12, 1e-12, 3e-13, 1e-13}) expect_closed(scene, tolerance);
}

TEST(Tolerance3, AWallOfTwoTrianglesIsOneElement) {
  const auto place = [](const char* digits) -> Rational { return Rational(Integer(digits)) / 1000000; };
  const auto quad = [&](std::vector<std::array<const char*, 3>> corners) {
    Polygon3 polygon;
    for (const auto& [x, y, z] : corners) polygon.points.push_back({place(x), place(y), place(z)});
    accept_nearly_plane(polygon, Rational(1) / 1000000);
    return polygon;
  };
  BoxScene3 scene;
  scene.polygon("bus", quad({{"-624338", "426157", "-646987"},
                             {"-331967", "-520841", "-780079"},
                             {"-331967", "-715683", "606297"},
                             {"-624338", "231315", "739388"}}));
  scene.polygon("boom", quad({{"-654795", "-249322", "-40089"},
                              {"-684032", "-154623", "-26780"},
                              {"-492771", "-96717", "-18642"},
                              {"-463534", "-191417", "-31951"}}));
  scene.polygon("side", quad({{"-654795", "-249322", "-40089"},
                              {"-463534", "-191417", "-31951"},
                              {"-463534", "-192809", "-22048"},
                              {"-654795", "-250714", "-30186"}}));
  for (const double tolerance : {1e-9, 1e-12}) {
    const RowsOf3 rows = rows_of(scene, tolerance);
    EXPECT_LE(rows.beyond, 1e-14);
    EXPECT_LE(rows.most_error, tolerance);
  }
}

TEST(Tolerance3, WhatIsSeenAtAllDoesNotDependOnIt) {
  std::set<std::pair<std::string, std::string>> expected;
  for (const double tolerance : {1e-12, 1e-9, 1e-3, 10.0}) {
    std::set<std::pair<std::string, std::string>> seen;
    for (const auto& [names, pair] : rows_of(nearly_flush_boxes(tenth_to(6)), tolerance).pairs)
      if (!pair.is_zero()) seen.insert(names);
    if (expected.empty()) expected = seen;
    EXPECT_EQ(seen, expected) << tolerance;
  }
}

TEST(Tolerance3, APairThatFailsIsNamedOnceWithWhatWasReached) {
  const auto refusal_of = [](const Scene3& scene, double tolerance) -> std::string {
    try {
      rows_of(scene, tolerance);
    } catch (const RequestError& error) {
      return error.what();
    }
    return "";
  };
  const auto count_of = [](const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
  };
  // Two plates and a screen between them. No double is as near to anything as the tolerance.
  const auto screened = [](const Rational& height) {
    BoxScene3 scene;
    scene.polygon("low", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    scene.polygon("high", {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}});
    scene.polygon("screen", {{{0, 0, height}, {1, 0, height}, {0, 1, height}}});
    return scene;
  };
  const std::string far = refusal_of(screened(Rational(1) / 2), 1e-20);
  EXPECT_THAT(far, HasSubstr("could not be measured within 1e-20 of the smaller area: "));
  EXPECT_THAT(far, HasSubstr(" was reached: "));
  EXPECT_THAT(far, HasSubstr(". Take a larger tolerance, such as 1e-"));
  EXPECT_THAT(far, Not(HasSubstr("all but touch")));
  EXPECT_EQ(count_of(far, "'low' and 'high'"), 1U) << far;
  EXPECT_THAT(refusal_of(screened(tenth_to(5)), 1e-20), HasSubstr("Some surfaces all but touch"));
}

TEST(Tolerance3, ASurfaceTooSmallForDoublesIsNamed) {
  BoxScene3 scene;
  scene.box("a", {0, 0, 0}, {1, 1, 1});
  scene.box("b", {1 / tenth_to(160), 0, 0}, {2 / tenth_to(160), 1, 2});
  try {
    rows_of(scene, 1e-9);
    ADD_FAILURE() << "was measured";
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is too small: surfaces may be 1e150 times smaller than the scene"));
  }
}

TEST(PairShares3, OfAllPatchesTogetherAreTheTolerance) {
  const PreparedScene3 prepared = prepare(two_boxes_along_a_wall(tenth_to(6)));
  for (const Granularity granularity : {Granularity::kFace, Granularity::kGroup}) {
    const ElementTable3& table = *prepared.elements(granularity);
    const PairShares3 shares(table, prepared.occluders().vertices(), 1e-9);
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> sums;
    for (const ElementTable3::Part& a : table.parts())
      for (const ElementTable3::Part& b : table.parts())
        if (!a.patch.is_sky() || !b.patch.is_sky()) sums[{a.holder, b.holder}] += shares.share(a, b);
    for (const auto& [holders, sum] : sums) {
      const double allowed = shares.allowed(holders.first, holders.second);
      EXPECT_EQ(allowed, 1e-9 * shares.least_area(holders.first, holders.second));
      EXPECT_LE(sum, allowed * (1 + 1e-12));
      EXPECT_GE(sum, allowed / 4);
    }
  }
}

TEST(IntegerReals3, QuotientsKeepTheirDigitsHoweverSmall) {
  const Integer third("333333333333333333333333333333333333333333333333333333333333");
  const Integer long_one("1" + std::string(60, '0'));
  for (const long bits : {0L, 70L, -70L}) {
    long double one;
    integer_reals::set_quotient(third * 3 + 1, long_one, bits, one);
    EXPECT_EQ(one, std::ldexp(1.0L, static_cast<int>(-bits)));
    long double small;
    integer_reals::set_quotient(1, Integer(3) << 200, bits, small);
    EXPECT_NEAR(static_cast<double>(std::ldexp(small, static_cast<int>(bits + 200)) * 3), 1, 1e-18);
    LongerReal longer;
    integer_reals::set_quotient(1, Integer(3) << 200, bits, longer);
    EXPECT_LE(abs(ldexp(longer, static_cast<int>(bits + 200)) * 3 - 1), LongerReal(1e-36));
    WideReal wide;
    integer_reals::set_quotient(1, Integer(3) << 200, bits, wide);
    EXPECT_LE(abs(ldexp(wide, static_cast<int>(bits + 200)) * 3 - 1), WideReal(1e-90));
  }
}

}  // namespace
}  // namespace hottel::tolerance_test
