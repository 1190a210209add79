// Scenes on which programs for view factors were seen to go wrong without a word (docs/robustness.md), as files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::failures_of_others_test {
namespace {

using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

using Corner = std::vector<std::string>;

// A coordinate as text, made by a rule from the text of another one.
using Coordinate = std::string (*)(const std::string&);
std::string as_it_is(const std::string& text) { return text; }
std::string millionth(const std::string& text) { return text + "e-6"; }
std::string times_a_million(const std::string& text) { return text + "e6"; }
std::string a_million_away(const std::string& text) {
  return "1" + std::string("00000") + text;  // 0.25: 1000000.25
}

std::string rectangle(const std::string& name, const std::string& group, const std::vector<Corner>& corners,
                      Coordinate coordinate) {
  std::string points;
  for (const Corner& corner : corners) {
    std::string point;
    for (const std::string& text : corner) point += (point.empty() ? "[" : ", ") + coordinate(text);
    points += (points.empty() ? "" : ", ") + point + "]";
  }
  return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "material": "m")" +
         (group.empty() ? "" : R"(, "group": ")" + group + "\"") + "}";
}

struct Box {
  std::string name;
  Corner low, high;
  bool is_room = false, has_bottom = true;
};

std::vector<std::string> sides_of(const Box& box, Coordinate coordinate) {
  const auto& [x0, y0, z0] = std::tie(box.low[0], box.low[1], box.low[2]);
  const auto& [x1, y1, z1] = std::tie(box.high[0], box.high[1], box.high[2]);
  const std::vector<std::pair<std::string, std::vector<Corner>>> sides{
      {"bottom", {{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}}},
      {"top", {{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}}},
      {"south", {{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}}},
      {"north", {{x1, y1, z0}, {x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}}},
      {"west", {{x0, y1, z0}, {x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}}},
      {"east", {{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}}}};
  std::vector<std::string> polygons;
  for (auto [name, corners] : sides) {
    if (name == "bottom" && !box.has_bottom) continue;
    if (box.is_room) std::swap(corners[1], corners[3]);
    polygons.push_back(rectangle(box.name + " " + name, box.is_room ? "" : box.name, corners, coordinate));
  }
  return polygons;
}

std::string scene_of(const std::vector<std::string>& polygons) {
  std::string list;
  for (const std::string& polygon : polygons) list += (list.empty() ? "" : ",\n") + polygon;
  return R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [)" + list + "]}";
}
std::string room_with(const std::vector<Box>& boxes, Coordinate coordinate = as_it_is,
                      const std::string& height = "1.0") {
  std::vector<std::string> polygons =
      sides_of({"room", {"0.0", "0.0", "0.0"}, {"1.0", "1.0", height}, true, true}, coordinate);
  for (const Box& box : boxes)
    for (const std::string& side : sides_of(box, coordinate)) polygons.push_back(side);
  return scene_of(polygons);
}

// The csv of a scene.
std::string csv_of(const std::string& scene) {
  const Workplace place;
  place.write("scene.json", scene);
  const Outcome outcome = place.run("hottel factors scene.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

struct Factors {
  std::map<std::pair<std::string, std::string>, double> pairs;
  std::map<std::string, double> rows;
};
Factors read(const std::string& csv) {
  Factors factors;
  for (const std::string& line : lines_of(csv)) {
    std::istringstream in(line);
    std::string from, to, factor;
    std::getline(in, from, ',');
    std::getline(in, to, ',');
    std::getline(in, factor, ',');
    if (from == "from") continue;
    factors.pairs[{from, to}] = std::strtod(factor.c_str(), nullptr);
    factors.rows[from] += factors.pairs[{from, to}];
  }
  return factors;
}
Factors factors_of(const std::string& scene) {
  Factors factors = read(csv_of(scene));
  for (const auto& [from, sum] : factors.rows) EXPECT_NEAR(sum, 1, 1e-11) << from;
  return factors;
}
double floor_to_ceiling(Factors factors) { return factors.pairs[{"room bottom", "room top"}]; }

const Box kStanding{"box", {"0.25", "0.25", "0.0"}, {"0.75", "0.75", "0.5"}};

TEST(FailuresOfOthers, ABoxOnAnUncutFloorIsRightWithABottomAndWithout) {
  Box without = kStanding;
  without.has_bottom = false;
  Factors with_bottom = factors_of(room_with({kStanding})), hollow = factors_of(room_with({without}));
  EXPECT_EQ(with_bottom.rows.count("box bottom"), 0u);
  EXPECT_NEAR(floor_to_ceiling(with_bottom) * 0.75, floor_to_ceiling(hollow), 1e-14) << "the same S";
  for (const std::string side : {"top", "south", "north", "west", "east"}) {
    const std::pair<std::string, std::string> pair{"room bottom", "box " + side + ":back"};
    EXPECT_EQ(with_bottom.pairs.count(pair), 0u);
    EXPECT_GT(hollow.pairs[pair], 0.04) << "without a bottom the floor sees the inside, and it is told";
  }
}

TEST(FailuresOfOthers, ABoxAMillionthAboveTheFloorIsAbove) {
  for (const auto& [z, top] : {std::pair("0.000001", "0.500001"), std::pair("0.000000000001", "0.500000000001")}) {
    const Factors near = factors_of(room_with({{"box", {"0.25", "0.25", z}, {"0.75", "0.75", top}}}));
    EXPECT_NEAR(near.rows.at("box bottom"), 1, 1e-12) << z;
    EXPECT_NEAR(near.pairs.at({"box bottom", "room bottom"}), 1, 1e-5) << z;
    EXPECT_NEAR(floor_to_ceiling(near), 0.75 * floor_to_ceiling(factors_of(room_with({kStanding}))), 1e-6) << z;
  }
}

TEST(FailuresOfOthers, SizeAndPlaceChangeNoBit) {
  const std::string csv = csv_of(room_with({kStanding}));
  EXPECT_EQ(csv_of(room_with({kStanding}, millionth)), csv);
  EXPECT_EQ(csv_of(room_with({kStanding}, times_a_million)), csv);
  EXPECT_EQ(csv_of(room_with({kStanding}, a_million_away)), csv);
}

TEST(FailuresOfOthers, TwoBoxesThatShareAFaceAreOne) {
  const Box one{"box", {"0.25", "0.25", "0.0"}, {"0.75", "0.5", "0.5"}},
      west{"west", {"0.25", "0.25", "0.0"}, {"0.5", "0.5", "0.5"}},
      east{"east", {"0.5", "0.25", "0.0"}, {"0.75", "0.5", "0.5"}},
      wide{"wide", {"0.375", "0.25", "0.0"}, {"0.75", "0.5", "0.5"}};
  const double expected = floor_to_ceiling(factors_of(room_with({one})));
  const Factors both = factors_of(room_with({west, east}));
  EXPECT_EQ(both.rows.count("west east"), 0u) << "what they share is covered on both";
  EXPECT_EQ(both.rows.count("east west"), 0u);
  EXPECT_NEAR(floor_to_ceiling(both), expected, 1e-13);
  EXPECT_NEAR(floor_to_ceiling(factors_of(room_with({west, wide}))), expected, 1e-13) << "they overlap";
  factors_of(room_with({west, {"other", {"0.5", "0.5", "0.0"}, {"0.75", "0.75", "0.5"}}}));  // an edge in common
}

// Strips of width 2 at distance 2 with a strip of width 1 half-way between, and finite length. By the definition, with
// the integrals along the strips in closed form:
//   F = 1/L * integral over u in [0, 1] of (1 - u) K(4 + u^2),   K(d^2) = 4/pi * (double integral of (d^2 + w^2)^-2)
// evaluated to 17 digits.
TEST(FailuresOfOthers, LongStripsDoNotConvergeToSomethingElse) {
  for (const auto& [length, expected] : {std::pair("200", 0.11726846708177135), std::pair("2000", 0.1179574339571917),
                                         std::pair("10000", 0.11801867778626126)}) {
    const std::string l = length;
    const Factors factors = factors_of(
        scene_of({rectangle("low", "", {{"-1", "0", "0"}, {"1", "0", "0"}, {"1", l, "0"}, {"-1", l, "0"}}, as_it_is),
                  rectangle("high", "", {{"-1", "0", "2"}, {"-1", l, "2"}, {"1", l, "2"}, {"1", "0", "2"}}, as_it_is),
                  rectangle("screen", "", {{"-0.5", "0", "1"}, {"0.5", "0", "1"}, {"0.5", l, "1"}, {"-0.5", l, "1"}},
                            as_it_is)}));
    EXPECT_NEAR(factors.pairs.at({"low", "high"}), expected, 1e-14) << length;
  }
}

// Howell C-11, evaluated to 20 digits.
TEST(FailuresOfOthers, FlatRoomsAndThinSheetsAreOrdinary) {
  EXPECT_NEAR(floor_to_ceiling(factors_of(room_with({}, as_it_is, "0.0001"))), 0.99980007097778848715, 1e-12);
  EXPECT_NEAR(floor_to_ceiling(factors_of(room_with({}, as_it_is, "0.0000001"))), 0.99999980000011495392, 1e-12);
  const Factors sheet = factors_of(room_with({{"box", {"0.25", "0.25", "0.5"}, {"0.75", "0.75", "0.5000001"}}}));
  EXPECT_NEAR(floor_to_ceiling(sheet), 0.0995063, 1e-6);
}

}  // namespace
}  // namespace hottel::failures_of_others_test
