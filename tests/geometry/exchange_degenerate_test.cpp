// Scenes where something touches, coincides, vanishes or goes beyond the range of double, with their exact answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/geometry/exchange_scenes.h"

namespace hottel {
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

TEST(DegenerateExchange2, ACrossingIsFourWallsThatMeet) {
  const Exact exact(scene_of({{"up", "-1", "-1", "1", "1", 0, 1}, {"down", "-1", "1", "1", "-1", 2, 3}}));
  // In each quadrant 2 S = sqrt(2) + sqrt(2) - 2.
  for (const auto& [from, to] : {std::pair("up", "down"), std::pair("up", "down:back"), std::pair("up:back", "down"),
                                 std::pair("up:back", "down:back")}) {
    EXPECT_EQ(exact.text(from, to), "-1 + 1*sqrt(2)");
    EXPECT_EQ(exact.visibility(from, to), 1);
    EXPECT_EQ(exact.value(from, to), exact.value(to, from));
  }
  EXPECT_EQ(exact.value("up", "up:back"), 0);
  EXPECT_EQ(exact.text("up", "sky"), "2");
}

TEST(DegenerateExchange2, APartitionLetsNothingThroughAtItsContacts) {
  const Exact exact(scene_of(room("4") + std::vector<Line>{{"partition", "1", "0", "3", "4", 1, 1}}));
  EXPECT_EQ(exact.value("left", "right"), 0);
  EXPECT_EQ(exact.visibility("left", "right"), -1);
  EXPECT_EQ(exact.text("left", "partition:back"), "1/2 + 1/2*sqrt(17)");
  EXPECT_EQ(exact.value("left", "partition:back"), 0.64038820320220756873);
  EXPECT_EQ(exact.value("left", "partition"), 0);
  // Left and right would see each other, and each of the six faces with a material the sky.
  EXPECT_EQ(hidden_pairs(exact.prepared(), Per::kFace, exact.matrix()).size(), 2u + 6u);
}

TEST(DegenerateExchange2, ABlockerAlongALineOfSightHidesByItsWidth) {
  const Exact exact(scene_of(room("4") + std::vector<Line>{{"blocker", "1", "1", "2", "2", 1, 1}}));
  EXPECT_EQ(exact.text("bottom", "top"), "-4 + 5/2*sqrt(2) + 1/2*sqrt(10)");
  EXPECT_EQ(exact.value("bottom", "top"), 0.279168184004231822);
  EXPECT_EQ(exact.value("bottom", "right"), 0.29289321881345247560);
  EXPECT_EQ(exact.visibility("bottom", "right"), 1);
  EXPECT_EQ(exact.text("bottom", "left"), "4 - 1*sqrt(10)");
}

TEST(DegenerateExchange2, TipsTouchingLetNothingThrough) {
  const auto halves = [](const std::string& tip) {
    return scene_of(room("4") +
                    std::vector<Line>{{"west", "0", "2", "2", "2", 1, 1}, {"east", tip, "2", "4", "2", 1, 1}});
  };
  const Exact closed(halves("2"));
  EXPECT_EQ(closed.value("bottom", "top"), 0);
  EXPECT_TRUE(closed.measure("bottom", "top").is_zero());
  EXPECT_EQ(closed.value("bottom", "right"), 0.1909830056250525759);
  EXPECT_EQ(closed.text("bottom", "west"), "-1 + 1*sqrt(5)");
  // A crack of 2^-10, of 2^-50, and far below the spacing of doubles.
  EXPECT_EQ(Exact(halves("2049/1024")).value("bottom", "top"), 1.7261241293054540646e-4);
  EXPECT_EQ(Exact(halves("2251799813685249/1125899906842624")).value("bottom", "top"), 1.5700924586837748851e-16);
  const Exact hair(halves("2." + std::string(299, '0') + "1"));
  const Enclosure enclosure = hair.factor("bottom", "top").enclosure();
  EXPECT_NEAR(hair.value("bottom", "top") / 1e-300, 1 / std::sqrt(32.0), 1e-12);  // S is the width over sqrt 2
  EXPECT_LT(enclosure.lower, enclosure.upper);
  EXPECT_GT(hair.visibility("bottom", "top"), 0);
}

TEST(DegenerateExchange2, ACrackBelowTheRangeOfDoubleIsNotNothing) {
  const Exact exact(
      scene_of(room("4") + std::vector<Line>{{"west", "0", "2", "2", "2", 1, 1},
                                             {"east", "2." + std::string(399, '0') + "1", "2", "4", "2", 1, 1}}));
  EXPECT_FALSE(exact.measure("bottom", "top").is_zero());
  EXPECT_EQ(exact.factor("bottom", "top"), (Rounded{0, 1}));
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(exact.factor("bottom", "top").enclosure(), (Enclosure{0, smallest}));
  EXPECT_EQ(exact.visibility("bottom", "top"), smallest) << "something is seen";
  EXPECT_EQ(exact.visibility("bottom", "west"), 1);
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

TEST(DegenerateExchange2, ADuplicateOfTheSameMaterialChangesNothing) {
  const std::vector<Line> scene = room("4") + std::vector<Line>{{"wall", "1", "1", "3", "2", 1, 2}};
  Printed expected = printed(scene_of(scene));
  const Exact twice(scene_of(scene + std::vector<Line>{{"again", "1", "1", "3", "2", 1, 2}}));
  EXPECT_TRUE(printed(twice.matrix()) == expected);
  EXPECT_FALSE(twice.matrix().has_row(twice.matrix().find("again").value()));
  EXPECT_EQ(twice.matrix().elements()[twice.matrix().find("again").value()].area.value, 0);
}

TEST(DegenerateExchange2, AnEdgeThereAndBackIsAThinWall) {
  const Exact one(scene_of(room("4") + std::vector<Line>{{"wall", "1", "1", "3", "2", 1, 2}}));
  const Exact two(
      scene_of(room("4") + std::vector<Line>{{"wall", "1", "1", "3", "2", 1}, {"other", "3", "2", "1", "1", 2}}));
  for (const std::string face : {"left", "top", "right", "bottom"}) {
    EXPECT_EQ(one.factor(face, "wall"), two.factor(face, "wall"));
    EXPECT_EQ(one.factor(face, "wall:back"), two.factor(face, "other"));
    EXPECT_EQ(two.value(face, "wall:back"), 0);
    EXPECT_EQ(two.value(face, "other:back"), 0);
  }
}

TEST(DegenerateExchange2, OverlapsOfOneMaterialBelongToTheFirstListed) {
  const Exact exact(
      scene_of({{"first", "0", "0", "2", "0"}, {"second", "1", "0", "3", "0"}, {"lid", "0", "-1", "3", "-1", 1, 1}}));
  EXPECT_EQ(exact.matrix().elements()[exact.matrix().find("first").value()].area, (Rounded{2, 0}));
  EXPECT_EQ(exact.matrix().elements()[exact.matrix().find("second").value()].area, (Rounded{1, 0}));
  const Exact apart(
      scene_of({{"first", "0", "0", "2", "0"}, {"second", "2", "0", "3", "0"}, {"lid", "0", "-1", "3", "-1", 1, 1}}));
  EXPECT_TRUE((exact.measure("first", "lid:back") - apart.measure("first", "lid:back")).is_zero());
  EXPECT_TRUE((exact.measure("second", "lid:back") - apart.measure("second", "lid:back")).is_zero());
}

// Row 10: the covered floor sees the inside of the box, the free floor the room.
TEST(DegenerateExchange2, ABoxOnAFloorHidesTheRoomFromTheCoveredFloor) {
  for (const bool has_bottom : {false, true}) {
    std::vector<Line> lines = room("8");
    lines.back() = {"floor", "8", "0", "0", "0"};
    // Two wide and one high, listed clockwise from outside: fronts outside.
    lines =
        lines + std::vector<Line>{
                    {"west", "3", "1", "3", "0", 1}, {"lid", "5", "1", "3", "1", 1}, {"east", "5", "0", "5", "1", 1}};
    if (has_bottom) lines.push_back({"bottom", "3", "0", "5", "0", 1});
    const Exact exact(scene_of(lines));
    // 2 S(floor, lid:back) = 2 sqrt(5) - 2, 2 S(floor, side:back) = 2 + 1 - sqrt(5)
    EXPECT_EQ(exact.text("floor", "lid:back"), "-1 + 1*sqrt(5)");
    EXPECT_EQ(exact.text("floor", "west:back"), "3/2 - 1/2*sqrt(5)");
    EXPECT_EQ(exact.text("floor", "east:back"), "3/2 - 1/2*sqrt(5)");
    EXPECT_EQ(exact.value("floor", "lid"), 0);
    EXPECT_EQ(exact.value("lid", "floor"), 0);
    if (!has_bottom) continue;
    EXPECT_EQ(exact.factor("bottom", "sky"), (Rounded{1, 0})) << "it looks down, under the floor";
    EXPECT_EQ(exact.value("floor", "bottom:back"), 0);
  }
}

TEST(DegenerateExchange2, AClosedCellKeepsItsLight) {
  std::vector<Line> lines = room("4");
  for (const Line& wall : std::vector<Line>{{"cell left", "1", "1", "1", "2", 1, 1},
                                            {"cell top", "1", "2", "2", "2", 1, 1},
                                            {"cell right", "2", "2", "2", "1", 1, 1},
                                            {"cell bottom", "2", "1", "1", "1", 1, 1}})
    lines.push_back(wall);
  const Exact exact(scene_of(lines));
  EXPECT_EQ(exact.text("cell left", "cell right"), "-1 + 1*sqrt(2)");
  EXPECT_EQ(exact.text("cell left", "cell top"), "1 - 1/2*sqrt(2)");
  for (const std::string inner : {"cell left", "cell top", "cell right", "cell bottom"})
    for (const std::string outer : {"left", "top", "right", "bottom", "cell right:back", "sky"})
      EXPECT_EQ(exact.value(inner, outer), 0) << inner << " " << outer;
  EXPECT_GT(exact.value("cell left:back", "left"), 0);
  EXPECT_EQ(exact.value("cell left:back", "cell right"), 0);
}

TEST(DegenerateExchange2, TouchingBoxesLetNothingThrough) {
  // Boxes [2,4]^2 and [4,6]^2 in [0,8]^2 touch in (4,4).
  std::vector<Line> lines = room("8");
  const auto box = [&lines](const std::string& name, const std::string& low, const std::string& high) {
    lines.push_back({name + " left", low, high, low, low, 1});
    lines.push_back({name + " top", high, high, low, high, 1});
    lines.push_back({name + " right", high, low, high, high, 1});
    lines.push_back({name + " bottom", low, low, high, low, 1});
  };
  box("a", "2", "4");
  box("b", "4", "6");
  const Exact exact(scene_of(lines));
  EXPECT_EQ(exact.value("a top", "b bottom"), 0);
  EXPECT_EQ(exact.value("a right", "b left"), 0);
  EXPECT_EQ(exact.text("a right", "b bottom"), "2 - 1*sqrt(2)");
  EXPECT_EQ(exact.visibility("a right", "b bottom"), 1);
  EXPECT_EQ(exact.text("a top", "b left"), "2 - 1*sqrt(2)");
  EXPECT_EQ(exact.value("a top", "a right"), 0);
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

// Points on which doubles get orientations wrong (Kettner et al.): one pair exchanges 3.7e-32 and is not lost.
TEST(DegenerateExchange2, KeepsAnExchangeBelowTheRoundingOfItsCoordinates) {
  const auto typed = [](double value) { return to_string(Rational(value)); };
  const std::string x1 = typed(7.3000000000000194), y1 = typed(7.3000000000000167);
  const std::string x2 = typed(24.000000000000068), y2 = typed(24.000000000000071);
  const std::string x3 = typed(24.00000000000005), y3 = typed(24.000000000000053);
  const std::string x4 = typed(0.50000000000001621), y4 = typed(0.50000000000001243);
  const Exact exact(scene_of({{"left", "-10", "-10", "-10", "40"},
                              {"top", "-10", "40", "40", "40"},
                              {"right", "40", "40", "40", "-10"},
                              {"bottom", "40", "-10", "-10", "-10"},
                              {"a", x4, y4, x1, y1, 1, 1},
                              {"b", x3, y3, "30", "20", 1, 1},
                              {"c", x2, y2, "20", "30", 1, 1}}));
  EXPECT_TRUE(exact.report().closure_is_exact);
  double smallest = 1;
  for (std::uint32_t i = 0; i < exact.matrix().size(); ++i)
    for (const double measure : exact.matrix().measures(i)) smallest = std::min(smallest, measure);
  EXPECT_NEAR(2 * smallest / 3.732e-32, 1, 1e-3);
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
}  // namespace hottel
