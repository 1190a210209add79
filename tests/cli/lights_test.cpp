// Lights as users meet them: radiosities of closed forms, the energy, what is told and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::lights_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string square(const std::string& lights) {
  return R"({ "hottel": 1, "dimension": 2, "materials": {"grey": {"reflectivity": 0.5}},
  "polylines": [{"name": "room", "points": [[0,0],[0,1],[1,1],[1,0]], "closed": true, "material": "grey"}],
  "lights": [)" +
         lights + "] }";
}

std::string cube(const std::string& lights, const std::string& more = "") {
  const std::vector<std::string> faces{"[0,0,0],[1,0,0],[1,1,0],[0,1,0]", "[0,0,1],[0,1,1],[1,1,1],[1,0,1]",
                                       "[0,0,0],[0,0,1],[1,0,1],[1,0,0]", "[0,1,0],[1,1,0],[1,1,1],[0,1,1]",
                                       "[0,0,0],[0,1,0],[0,1,1],[0,0,1]", "[1,0,0],[1,0,1],[1,1,1],[1,1,0]"};
  std::string polygons;
  for (std::size_t k = 0; k < faces.size(); ++k)
    polygons += (k == 0 ? "" : ",\n") + std::string(R"({"name": "f)") + std::to_string(k) + R"(", "points": [)" +
                faces[k] + R"(], "material": "grey"})";
  return R"({ "hottel": 1, "dimension": 3, "materials": {"grey": {"reflectivity": 0.5}}, "polygons": [)" + polygons +
         more + "], \"lights\": [" + lights + "] }";
}

// Face, element, channel, area, emission, reflectivity, radiosity, lower, upper, irradiance, net.
struct Row {
  std::string face, channel;
  double emission, radiosity, lower, upper, irradiance;
};
std::vector<Row> rows(const std::string& csv) {
  std::vector<Row> result;
  for (const std::string& line : lines_of(csv)) {
    std::vector<std::string> cell;
    std::istringstream stream(line);
    for (std::string text; std::getline(stream, text, ',');) cell.push_back(text);
    if (cell[0] == "face") continue;
    result.push_back({cell[0], cell[2], std::stod(cell[4]), std::stod(cell[6]), std::stod(cell[7]), std::stod(cell[8]),
                      std::stod(cell[9])});
  }
  return result;
}

void expect_all_ones(const std::vector<Row>& found, std::size_t count) {
  ASSERT_EQ(found.size(), count);
  for (const Row& row : found) {
    EXPECT_EQ(row.emission, 0) << row.face;
    EXPECT_LE(row.lower, 1) << row.face;
    EXPECT_GE(row.upper, 1) << row.face;
    EXPECT_NEAR(row.radiosity, 1, 1e-12) << row.face;
    EXPECT_NEAR(row.irradiance, 2, 1e-12) << row.face;  // 1 from the other faces, 1 from the light
  }
}

TEST(Lights, InTheMiddleOfASquareAndOfACubeLightAllFacesAlike) {
  const Workplace place;
  place.write("square.json", square(R"({"type": "point", "position": [0.5, 0.5], "power": 4})"));
  place.write("cube.json", cube(R"({"type": "point", "position": [0.5, 0.5, 0.5], "power": 6})"));
  ASSERT_EQ(place.run("hottel solve square.json -o square").code, 0);
  ASSERT_EQ(place.run("hottel solve cube.json -o cube").code, 0);
  expect_all_ones(rows(place.read("square/radiosity.csv")), 4);
  expect_all_ones(rows(place.read("cube/radiosity.csv")), 6);
  for (const auto& [folder, power] : {std::pair("square", 4.0), {"cube", 6.0}}) {
    const auto report = nlohmann::json::parse(place.read(std::string(folder) + "/report.json"));
    EXPECT_NEAR(report["energy"]["emitted"], power, 1e-13);
    EXPECT_NEAR(report["energy"]["absorbed"], power, 1e-12);
    EXPECT_EQ(report["energy"]["to_sky"], 0);
  }
}

// A face above the light in the open takes its solid angle; the rest is the sky's.
TEST(Lights, WhatTheSkyGetsIsInTheEnergy) {
  const Workplace place;
  place.write("plate.json", R"({ "hottel": 1, "dimension": 3, "materials": {"m": {}},
    "polygons": [{"name": "plate", "points": [[-1,-1,1],[-1,1,1],[1,1,1],[1,-1,1]], "material": "m"}],
    "lights": [{"type": "point", "position": [0,0,0], "power": 12}] })");
  ASSERT_EQ(place.run("hottel solve plate.json -o out").code, 0);
  const auto energy = nlohmann::json::parse(place.read("out/report.json"))["energy"];
  EXPECT_NEAR(energy["emitted"], 12, 1e-13);
  EXPECT_NEAR(energy["absorbed"], 2, 1e-13);  // a sixth of all directions, as that of a cube
  EXPECT_NEAR(energy["to_sky"], 10, 1e-13);
}

TEST(Lights, HaveChannels) {
  const Workplace place;
  place.write("square.json", square(R"({"type": "spot", "position": [0.5, 0.5], "direction": [0, -1], "focus": 45,
    "falloff": 1, "power": [1, 2, 0]})"));
  ASSERT_EQ(place.run("hottel solve square.json -o out").code, 0);
  const std::vector<Row> found = rows(place.read("out/radiosity.csv"));
  ASSERT_EQ(found.size(), 12u);
  for (std::size_t k = 0; k < 12; k += 3) {
    EXPECT_NEAR(found[k + 1].radiosity, 2 * found[k].radiosity, 1e-14);
    EXPECT_EQ(found[k + 2].radiosity, 0);
  }
}

TEST(Lights, OnSurfacesAndInSolids) {
  const Workplace place;
  const std::string box = R"(,
    {"name": "b0", "group": "box", "points": [["1/4","1/4","1/4"],["1/4","3/4","1/4"],["3/4","3/4","1/4"],["3/4","1/4","1/4"]], "material": "grey"},
    {"name": "b1", "group": "box", "points": [["1/4","1/4","3/4"],["3/4","1/4","3/4"],["3/4","3/4","3/4"],["1/4","3/4","3/4"]], "material": "grey"},
    {"name": "b2", "group": "box", "points": [["1/4","1/4","1/4"],["3/4","1/4","1/4"],["3/4","1/4","3/4"],["1/4","1/4","3/4"]], "material": "grey"},
    {"name": "b3", "group": "box", "points": [["1/4","3/4","1/4"],["1/4","3/4","3/4"],["3/4","3/4","3/4"],["3/4","3/4","1/4"]], "material": "grey"},
    {"name": "b4", "group": "box", "points": [["1/4","1/4","1/4"],["1/4","1/4","3/4"],["1/4","3/4","3/4"],["1/4","3/4","1/4"]], "material": "grey"},
    {"name": "b5", "group": "box", "points": [["3/4","1/4","1/4"],["3/4","3/4","1/4"],["3/4","3/4","3/4"],["3/4","1/4","3/4"]], "material": "grey"})";
  place.write("in.json", cube(R"({"type": "point", "name": "lost", "position": [0.5, 0.5, 0.5], "power": 6})", box));
  const Outcome in = place.run("hottel solve in.json -o in");
  ASSERT_EQ(in.code, 0) << in.err;
  EXPECT_THAT(in.err, HasSubstr("light 'lost' is in the solid 'box': its power is lost there"));
  for (const Row& row : rows(place.read("in/radiosity.csv"))) EXPECT_EQ(row.radiosity, 0);
  const auto energy = nlohmann::json::parse(place.read("in/report.json"))["energy"];
  EXPECT_NEAR(energy["emitted"], 6, 1e-13);
  EXPECT_THAT(place.run("hottel check in.json").out, HasSubstr("light-in-solid"));

  place.write("on.json", cube(R"({"type": "point", "name": "stuck", "position": [0, 0.5, 0.5], "power": 6})"));
  const Outcome on = place.run("hottel solve on.json -o on");
  EXPECT_EQ(on.code, 3);
  EXPECT_THAT(on.err, HasSubstr("light 'stuck' lies on the surface 'f4'"));
}

TEST(Lights, ALampThatLightsNothingIsTold) {
  const Workplace place;
  const std::string told = "note: light 'bulb' shines on no face with a material: its power goes to ";
  place.write("out.json", square(R"({"type": "point", "name": "bulb", "position": [9, 9], "power": 6})"));
  EXPECT_THAT(place.run("hottel solve out.json -o out").err, HasSubstr(told));
  place.write("away.json", cube(R"({"type": "spot", "name": "bulb", "position": [9, 9, 9], "direction": [1, 1, 1],
    "focus": 4, "power": 6})"));
  EXPECT_THAT(place.run("hottel solve away.json -o away").err, HasSubstr(told));
  for (const char* power : {"0", "6"}) {
    place.write("in.json", square(R"({"type": "point", "name": "bulb", "position": [0.5, 0.5], "power": )" +
                                  std::string(power) + "}"));
    EXPECT_THAT(place.run("hottel solve in.json -o in").err, Not(HasSubstr("shines on no face")));
  }
}

TEST(Lights, TooBrightForDoublesIsToldByName) {
  const Workplace place;
  place.write("square.json", square(R"({"type": "point", "position": [0.5, 0.5], "power": "1e400"})"));
  place.write("cube.json", cube(R"({"type": "point", "position": [0.5, 0.5, 0.5], "power": "1e400"})"));
  for (const auto& [scene, face] : {std::pair("square.json", "room[0]"), {"cube.json", "f0"}}) {
    const Outcome outcome = place.run(std::string("hottel solve ") + scene + " -o out");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, HasSubstr(std::string(scene) + ": the light of lamps on '" + face +
                                       "' is beyond the range of doubles"));
    const Outcome check = place.run(std::string("hottel check ") + scene);
    EXPECT_EQ(check.code, 1);
    EXPECT_THAT(check.out, HasSubstr("beyond-doubles"));
  }
}

TEST(Lights, AveragesOverCellsAreRefused) {
  const Workplace place;
  place.write("square.json", square(R"({"type": "point", "position": [0.5, 0.5], "power": 4})"));
  for (const std::string kind : {"average", "inverse-square"}) {
    const Outcome outcome = place.run("hottel solve square.json -o out --illumination " + kind);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("square.json: light by \"" + kind + "\" does not know the scene's lights"));
  }
}

// What tests of centroids and vertices give is off, in the energy too, and all that is said.
TEST(Lights, ByTestsOfPointsAreToldToBeEstimates) {
  const Workplace place;
  place.write("square.json", square(R"({"type": "point", "position": [0.5, 0.5], "power": 4})"));
  place.write("cube.json", cube(R"({"type": "point", "position": [0.5, 0.5, 0.5], "power": [6, 3, 0]})"));
  const double pi = std::acos(-1.0);
  for (const auto& [name, power, sum, off] :
       {std::tuple("square", 4.0, 4 / pi, "27.3 % of the power of the lights too much"),
        {"cube", 9.0, 6 / pi, "91 % of the power of the lights too much"}})
    for (const std::string test : {"centroid", "vertices"}) {
      const Outcome outcome = place.run(std::string("hottel solve ") + name + ".json -o out --lights " + test);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_THAT(outcome.err,
                  HasSubstr("note: what lights shine on first is an estimate (test: " + test + "), " + off));
      const auto report = nlohmann::json::parse(place.read("out/report.json"));
      EXPECT_NEAR(report["energy"]["emitted"], power, 1e-13);
      EXPECT_NEAR(report["energy"]["absorbed"], power * sum, 1e-8);
      EXPECT_NEAR(report["energy"]["defect"], power * (1 - sum), 1e-8);
      EXPECT_EQ(report["bounds"]["guarantee"], "estimated");
      EXPECT_THAT(report["notes"].dump(), HasSubstr("and say nothing of the scene"));
      EXPECT_NEAR(rows(place.read("out/radiosity.csv"))[0].radiosity, sum, 1e-8);
    }
}

TEST(Lights, AreKeptByConvertAndTheSameAgain) {
  const Workplace place;
  for (const std::string name : {"torch", "hall"}) {
    const std::string scene = std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/" + name + ".json";
    ASSERT_EQ(place.run("hottel convert " + scene + " once.json").code, 0);
    ASSERT_EQ(place.run("hottel convert once.json twice.json").code, 0);
    EXPECT_THAT(place.read("once.json"), HasSubstr("\"lights\": ["));
    EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
    ASSERT_EQ(place.run("hottel solve " + scene + " -o a --no-picture --no-illumination").code, 0);
    ASSERT_EQ(place.run("hottel solve once.json -o b --no-picture --no-illumination").code, 0);
    EXPECT_EQ(place.read("a/radiosity.csv"), place.read("b/radiosity.csv"));
  }
}

}  // namespace
}  // namespace hottel::lights_test
