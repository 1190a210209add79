// What takes more than one scene, or more than its numbers, to say of scenes/degenerate/; and what goes beyond the
// range of double.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "tests/geometry/plane/degenerate_scenes.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::exchange_degenerate_test {
namespace {

using namespace testing_scenes;

TEST(DegenerateExchange2, ASingleEdgeSeesOnlyTheSky) {
  const Exact exact(scene_of({{"wall", "0.1", "1/3", "7", "11", 0, 1}}));
  for (const std::string face : {"wall", "wall:back"}) {
    EXPECT_EQ(exact.factor(face, "sky"), (Rounded{1, 0}));
    EXPECT_EQ(exact.visibility(face, "sky"), 1);
    EXPECT_EQ(exact.value(face, "wall"), 0);
    EXPECT_EQ(exact.value(face, "wall:back"), 0);
  }
  EXPECT_EQ(exact.matrix().entry_count(), 2u);
}

TEST(DegenerateExchange2, ASceneOnOneLineSeesOnlyTheSky) {
  // Neighbours, a gap, and an overlap of equal material.
  const Exact exact(scene_of({{"a", "0", "0", "1", "2", 0, 0},
                              {"b", "1", "2", "2", "4", 0, 0},
                              {"c", "3", "6", "5", "10", 0, 0},
                              {"d", "4", "8", "7", "14", 0, 0}}));
  EXPECT_EQ(exact.matrix().entry_count(), 8u);
  for (const std::string face : {"a", "b", "c", "d", "a:back", "b:back", "c:back", "d:back"})
    EXPECT_EQ(exact.factor(face, "sky"), (Rounded{1, 0})) << face;
}

// A crack in a wall across the room, of the given width.
Scene2 cracked(const std::string& width) {
  return scene_of(room("4") +
                  std::vector<Line>{{"west", "0", "2", "2", "2", 1, 1}, {"east", "2." + width, "2", "4", "2", 1, 1}});
}

TEST(DegenerateExchange2, ACrackOf1eMinus300LetsItsWidthThrough) {
  const Exact hair(cracked(std::string(299, '0') + "1"));
  const Enclosure enclosure = hair.factor("bottom", "top").enclosure();
  EXPECT_NEAR(hair.value("bottom", "top") / 1e-300, 1 / std::sqrt(32.0), 1e-12);  // S is the width over sqrt 2
  EXPECT_LT(enclosure.lower, enclosure.upper);
  EXPECT_GT(hair.visibility("bottom", "top"), 0);
}

TEST(DegenerateExchange2, ACrackBelowTheRangeOfDoubleIsNotNothing) {
  const Exact exact(cracked(std::string(399, '0') + "1"));
  EXPECT_FALSE(exact.measure("bottom", "top").is_zero());
  EXPECT_EQ(exact.factor("bottom", "top"), (Rounded{0, 1}));
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(exact.factor("bottom", "top").enclosure(), (Enclosure{0, smallest}));
  EXPECT_EQ(exact.visibility("bottom", "top"), smallest) << "something is seen";
  EXPECT_EQ(exact.visibility("bottom", "west"), 1);
}

double largest_change(const Printed& before, const Printed& after) {
  double largest = 0;
  const auto factor = [](const Printed& numbers, const auto& key) {
    const auto place = numbers.find(key);
    return place == numbers.end() ? 0.0 : std::get<0>(place->second);
  };
  for (const Printed* numbers : {&before, &after})
    for (const auto& entry : *numbers)
      largest = std::max(largest, std::abs(factor(before, entry.first) - factor(after, entry.first)));
  return largest;
}

// The scene with the second point of one edge moved.
Scene2 with_tip_moved(Scene2 scene, const std::string& name, const Rational& x, const Rational& y) {
  Point2& tip = scene.edges[scene.find(name).value()].to;
  tip = {tip.x + x, tip.y + y};
  return scene;
}

TEST(DegenerateExchange2, GrazingTipsAreContinuousInTheirPlaces) {
  const Scene2 grazing = degenerate("grazing_tips");
  for (int bits = 10; bits <= 50; bits += 10)
    for (const int sign : {-1, 1}) {
      const Rational lift = scaled_by_power_of_two(sign, -bits);
      const Exact lifted(with_tip_moved(grazing, "second", 0, lift));
      EXPECT_LE(largest_change(printed(grazing), printed(lifted.matrix())), 2 * std::abs(to_double(lift)));
      EXPECT_EQ(lifted.value("left", "right") > 0, sign > 0) << "only raised it lets something through";
    }
}

TEST(DegenerateExchange2, AFinOnAnEdgeIsTheEdgeCutThere) {
  const Scene2 whole = degenerate("fin_on_wall");
  Scene2 cut = whole;
  const std::uint32_t wall = cut.find("wall").value();
  Surface rest = cut.surfaces[wall];
  rest.name = "rest";
  cut.add(rest, {{2, 1}, cut.edges[wall].to});
  cut.edges[wall].to = {2, 1};
  const Exact one(whole), two(cut);
  for (const std::string side : {"", ":back"})
    for (const std::string other : {"west", "north", "east", "south", "fin", "fin:back"}) {
      const RootSum parts = two.measure("wall" + side, other) + two.measure("rest" + side, other);
      EXPECT_TRUE((one.measure("wall" + side, other) - parts).is_zero()) << side << " " << other;
    }
  EXPECT_EQ(two.value("wall:back", "rest:back"), 0);
  EXPECT_EQ(two.value("wall:back", "fin"), 0);
  EXPECT_EQ(two.value("rest:back", "fin:back"), 0);
}

TEST(DegenerateExchange2, ACopyOwnsNothingAndHasNoRows) {
  const ExchangeMatrix matrix = exact_exchange(prepare(degenerate("duplicate_edge")));
  EXPECT_FALSE(matrix.has_row(matrix.find("copy").value()));
  EXPECT_EQ(matrix.elements()[matrix.find("copy").value()].area.value, 0);
  Printed numbers = printed(matrix);
  EXPECT_TRUE(numbers == printed(degenerate("blocker_on_bitangent")));
}

TEST(DegenerateExchange2, AnEdgeThereAndBackIsOneWithTwoSides) {
  const Exact thin(degenerate("edge_there_and_back"));
  EXPECT_TRUE(printed(thin.matrix(), [](const std::string& name) {
                return name == "there" ? "blocker" : name == "back again" ? "blocker:back" : name;
              }) == printed(degenerate("blocker_on_bitangent")));
}

TEST(DegenerateExchange2, OrderAndDirectionOfTheInputChangeNothing) {
  const ExchangeMatrix shuffled = exact_exchange(prepare(degenerate("same_edges_shuffled")));
  EXPECT_TRUE(printed(shuffled, [](const std::string& name) {
                return name == "blocker" ? "blocker:back" : name == "blocker:back" ? "blocker" : name;
              }) == printed(degenerate("blocker_on_bitangent")));
}

TEST(DegenerateExchange2, FarAwayNothingChanges) {
  EXPECT_TRUE(printed(degenerate("tips_touch_far_away")) == printed(degenerate("tips_touch")));
}

// Returns the message and the hints of the error that reading and preparing a scene of refused/ ends in.
std::string refusal(const std::string& stem) {
  try {
    prepare(degenerate("refused/" + stem));
  } catch (const InputError& error) {
    std::string text = error.what();
    for (const std::string& hint : error.hints()) text += "\n" + hint;
    return text;
  }
  return "";
}

TEST(DegenerateExchange2, RefusalsNameTheEdgesAndThePlace) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(refusal("conflicting_claims"),
              AllOf(HasSubstr("conflicting_claims.json:10: 'white' (front) and 'black' (front)"),
                    HasSubstr("(1, 0) to (2, 0)"), HasSubstr("right")));
  EXPECT_THAT(refusal("zero_length_edge"),
              AllOf(HasSubstr("zero_length_edge.json:12: edge 'point'"), HasSubstr("length zero")));
}

TEST(DegenerateExchange2, ConcurrentBitangentsMakeOneCriticalPoint) {
  const PreparedScene2 prepared = prepare(degenerate("three_concurrent_bitangents"));
  const auto side = [&](const std::string& name) { return Face{prepared.scene.find(name).value(), false}; };
  int lines = 0;
  for (const CriticalPoint2& point :
       critical_points(prepared.arrangement, prepared.scene, side("floor"), side("ceiling")))
    if (point.t == Rational(1, 2)) {
      ++lines;
      EXPECT_FALSE(point.is_jump);
      EXPECT_EQ(point.point, (Point2{4, 0}));
    }
  EXPECT_EQ(lines, 3);
}

TEST(DegenerateExchange2, NeedlesOfAViewHaveNoArea) {
  const PreparedScene2 prepared = prepare(degenerate("needle_polygon"));
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const VisibilityPolygon2 view = visibility_polygon(arrangement, location, {1, 5});
  EXPECT_EQ(view.location.kind, Location2::Kind::kOnVertex);
  Rational area = 0;  // of what is seen of the room; around the corner one sees out
  for (const VisibilityPolygon2::Part& part : view.parts) {
    if (part.side == kSky || arrangement.owner(part.side).is_back) continue;
    const Rational ax = part.from.x - 1, ay = part.from.y - 5, bx = part.to.x - 1, by = part.to.y - 5;
    area += (ax * by - ay * bx) / 2;
  }
  EXPECT_EQ(area, Rational(5, 2));
}

TEST(DegenerateExchange2, OnlyTheCanonicalSumOfRootsSettlesATie) {
  const auto tier = [](const std::string& stem) {
    const PreparedScene2 prepared = prepare(degenerate(stem));
    const ExactPair2 pair = exact_pair(prepared, Granularity::kFace, 0, 2);  // floor and wall
    return round_quotient(pair.exchange, pair.area_from);
  };
  const RoundedByTier tie = tier("rounding_tie"), below = tier("rounding_just_below_a_tie"),
                      above = tier("rounding_just_above_a_tie");
  EXPECT_EQ(tie.tier, Tier::kRootSum);
  EXPECT_EQ(tie.number, (Rounded{0.5, -1}));
  EXPECT_EQ(below.tier, Tier::kBall);
  EXPECT_EQ(below.number, (Rounded{0.49999999999999994, 1}));
  EXPECT_EQ(above.tier, Tier::kBall);
  EXPECT_EQ(above.number, (Rounded{0.5, -1}));
  // The same in the chain, where fixed-point sums come first.
  ExchangeReport report;
  exact_exchange(prepare(degenerate("rounding_tie")), {}, &report);
  EXPECT_GT(report.tiers.by_tier[static_cast<int>(Tier::kRootSum)], 0u);
}

// Points on which doubles get orientations wrong (Kettner et al.), set A1.
TEST(DegenerateExchange2, KeepsAnExchangeBelowTheRoundingOfItsCoordinates) {
  const Exact exact(degenerate("kettner_a1"));
  double smallest = 1;
  for (std::uint32_t i = 0; i < exact.matrix().size(); ++i)
    for (const double measure : exact.matrix().measures(i)) smallest = std::min(smallest, measure);
  EXPECT_NEAR(2 * smallest / 3.732e-32, 1, 2e-4);
}

TEST(DegenerateExchange2, SomethingHiddenIsNeverFullVisibility) {
  // A speck of 1e-30 in front of a wall of length 4.
  const Exact exact(
      scene_of(room("4") + std::vector<Line>{{"speck", "1", "1", "1." + std::string(29, '0') + "1", "1", 1, 1}}));
  EXPECT_EQ(exact.visibility("bottom", "top"), std::nextafter(1.0, 0.0));
  EXPECT_EQ(exact.visibility("bottom", "left"), std::nextafter(1.0, 0.0));
  // Nothing hidden, though a tip touches a line of sight: the corner of the region is met, not cut.
  const Exact touched(scene_of(room("4") + std::vector<Line>{{"fin", "0", "4", "2", "2", 1, 1}}));
  EXPECT_EQ(touched.visibility("bottom", "right"), 1);
}

TEST(DegenerateExchange2, IsTheSameAtEverySize) {
  const Printed expected = printed(scene_of(room("4") + std::vector<Line>{{"wall", "1", "1", "3", "2", 1, 2}}));
  for (const std::string exponent : {"-300", "300", "-4000", "4000", "-310", "309"}) {
    const auto times = [&](const std::string& digits) { return digits + "e" + exponent; };
    std::vector<Line> lines = room(times("4"));
    lines.push_back({"wall", times("1"), times("1"), times("3"), times("2"), 1, 2});
    EXPECT_TRUE(printed(scene_of(lines)) == expected) << exponent;
  }
}

TEST(DegenerateExchange2, ReadsEveryDigit) {
  // A plate above its equal by 1 + 1e-40: the answer moves, if only on one side of a double.
  const auto plates = [](const std::string& height) {
    return scene_of({{"low", "1", "0", "0", "0"}, {"high", "0", height, "1", height}});
  };
  const Exact one(plates("1")), more(plates("1." + std::string(39, '0') + "1"));
  EXPECT_EQ(one.text("low", "high"), "-1 + 1*sqrt(2)");
  EXPECT_EQ(one.value("low", "high"), more.value("low", "high"));
  EXPECT_EQ((one.measure("low", "high") - more.measure("low", "high")).sign(), 1);
  // 40 digits everywhere: the large form.
  const std::string digits = "0.1234567890123456789012345678901234567891";
  const Exact long_scene(scene_of(
      {{"low", "1", digits, "0", digits}, {"high", "0", "1." + digits.substr(2), "1", "1." + digits.substr(2)}}));
  EXPECT_EQ(long_scene.factor("low", "high"), one.factor("low", "high"));
  EXPECT_TRUE((long_scene.measure("low", "high") - one.measure("low", "high")).is_zero());
}

TEST(DegenerateExchange2, HoldsScalesApartThatNoDoubleHolds) {
  // A mote of length 1e-300, looking down at a floor from -1e300 to 1e300 one below it. From each of its points the sky
  // is left with about (1e-300)^2 / 2: far below the range of double.
  const Exact exact(scene_of({{"floor", "1e300", "0", "-1e300", "0"}, {"mote", "0", "1", "1e-300", "1"}}));
  EXPECT_EQ(exact.factor("mote", "floor"), (Rounded{1, -1}));
  EXPECT_EQ(exact.factor("mote", "sky"), (Rounded{0, 1}));
  EXPECT_EQ(exact.visibility("mote", "floor"), 1);
  // Half the length of the mote over twice that of the floor is below the range as well.
  EXPECT_EQ(exact.factor("floor", "mote"), (Rounded{0, 1}));
  EXPECT_EQ(exact.visibility("floor", "mote"), 1);
  EXPECT_EQ(exact.factor("floor", "sky"), (Rounded{1, -1}));
}

}  // namespace
}  // namespace hottel::exchange_degenerate_test
