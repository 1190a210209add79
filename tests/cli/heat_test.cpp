// Heat: the temperature of the sky, insulated faces, sky view factors of a street, the unit of length.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/black_power.h"
#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::heat_test {
namespace {

using testing::HasSubstr;
using testing_cli::cells_of;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::power_of;
using testing_cli::table;
using testing_cli::Workplace;
using Json = nlohmann::json;

std::string street(const std::string& height) {
  return R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [
    {"name": "road", "points": [[1, 0], [0, 0]], "material": "m"},
    {"name": "west", "points": [[0, 0], [0, ")" +
         height + R"("]], "material": "m"},
    {"name": "east", "points": [[1, ")" +
         height + R"("], [1, 0]], "material": "m"}]})";
}

// Oke, Canyon geometry and the nocturnal urban heat island, Journal of Climatology 1, 1981; Johnson and Watson, Journal
// of Climate and Applied Meteorology 23, 1984: of the width 1 and the height h.
TEST(StreetCanyon, HasOkesSkyViewFactors) {
  for (const auto& [text, h] : {std::pair{"1/4", 0.25L}, {"1/2", 0.5L}, {"1", 1.0L}, {"3/2", 1.5L}, {"5", 5.0L}}) {
    const Workplace place;
    place.write("street.json", street(text));
    const auto factors = table(place.run("hottel factors street.json --quiet").out, 2);
    const auto factor = [&](const char* key) { return std::stod(factors.at(key).at(2)); };
    const long double road = std::sqrt(1 + h * h) - h, wall = (1 + h - std::sqrt(1 + h * h)) / (2 * h);
    EXPECT_NEAR(factor("road,sky"), static_cast<double>(road), 2e-16) << text;
    EXPECT_NEAR(factor("west,sky"), static_cast<double>(wall), 2e-16) << text;
    EXPECT_EQ(factor("east,sky"), factor("west,sky"));
    // In the middle of the road: cos(atan(2 h)).
    const Json middle = Json::parse(place.run("hottel visibility street.json --on road --at 1/2 --json --quiet").out);
    double seen = -1;
    for (const Json& each : middle["factors"])
      if (each["to"] == "sky") seen = each["factor"]["value"];
    EXPECT_NEAR(seen, static_cast<double>(std::cos(std::atan(2 * h))), 2e-16) << text;
  }
}

TEST(SkyTemperature, IsWhatABlackSkySends) {
  const Workplace place;
  std::string text = street("1");
  place.write("street.json", text.insert(text.size() - 1, R"(, "sky": {"temperature": 270})"));
  ASSERT_EQ(place.run("hottel convert street.json same.json").code, 0);
  EXPECT_THAT(place.read("same.json"), HasSubstr("\"sky\": {\"temperature\": 270}"));
  ASSERT_EQ(place.run("hottel solve street.json -o out --no-illumination").code, 0);
  const auto radiosities = table(place.read("out/radiosity.csv"), 1);
  const auto factors = table(place.run("hottel factors street.json --quiet").out, 2);
  const double power = power_of(270.0);
  for (const char* face : {"road", "west", "east"})
    EXPECT_NEAR(std::stod(radiosities.at(face).at(9)), power * std::stod(factors.at(std::string(face) + ",sky").at(2)),
                1e-12 * power);
}

// A square with a hot floor and a cold ceiling, both black: by symmetry the insulated sides come to
// ((400⁴ + 300⁴)/2)^(1/4), whatever is typed about where they are cut.
constexpr const char* kSquare = R"({"hottel": 1, "dimension": 2, "unit": "ft", "closed": true, "materials": {
  "hot": {"emissivity": 1, "temperature": 400}, "cold": {"emissivity": 1, "temperature": 300},
  "wool": {"insulated": true}}, "edges": [
  {"name": "floor", "points": [[1, 0], [0, 0]], "material": "hot"},
  {"name": "west", "points": [[0, 0], [0, 1]], "material": "wool"},
  {"name": "ceiling", "points": [[0, 1], [1, 1]], "material": "cold"},
  {"name": "east", "points": [[1, 1], [1, 0]], "material": "wool"}]})";
constexpr const char* kCube = R"({"hottel": 1, "dimension": 3, "unit": "ft", "closed": true, "materials": {
  "hot": {"emissivity": 1, "temperature": 400}, "cold": {"emissivity": 1, "temperature": 300},
  "wool": {"insulated": true}}, "polygons": [
  {"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "hot"},
  {"name": "ceiling", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "cold"},
  {"name": "west", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "wool"},
  {"name": "east", "points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "wool"},
  {"name": "south", "points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "wool"},
  {"name": "north", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "wool"}]})";

TEST(Insulated, FacesComeToTheTemperatureBetweenAndGiveNothingAway) {
  const double mean = std::pow((std::pow(400.0, 4) + std::pow(300.0, 4)) / 2, 0.25);
  for (const char* scene : {kSquare, kCube}) {
    const Workplace place;
    place.write("room.json", scene);
    const Outcome outcome = place.run("hottel solve room.json -o out --no-illumination");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("insulated: 'west' 360.288 K, 'east' 360.288 K"));
    const auto temperatures = table(place.read("out/temperature.csv"), 1),
               fluxes = table(place.read("out/flux.csv"), 2);
    EXPECT_EQ(temperatures.at("face"),
              (std::vector<std::string>{"face", "element", "channel", "temperature", "lower", "upper"}));
    EXPECT_EQ(temperatures.at("floor"), (std::vector<std::string>{"floor", "0", "all", "400", "400", "400"}));
    for (const char* face : {"west", "east"}) {
      const auto& row = temperatures.at(face);
      EXPECT_NEAR(std::stod(row[3]), mean, 1e-7);
      EXPECT_LE(std::stod(row[4]), std::stod(row[3]));
      EXPECT_GE(std::stod(row[5]), std::stod(row[3]));
      const auto& flux = fluxes.at(std::string("face,") + face);
      EXPECT_LE(std::stod(flux[5]), 0);
      EXPECT_GE(std::stod(flux[6]), 0);
      EXPECT_NEAR(std::stod(flux[4]), 0, 1e-6);
    }
    const Json report = Json::parse(place.read("out/report.json"));
    EXPECT_EQ(report["unit"], "ft");
    EXPECT_EQ(report["insulated"][0]["name"], "west");
    EXPECT_LE(report["insulated"][0]["lower"].get<double>(), mean + 1e-7);
    EXPECT_GE(report["insulated"][0]["upper"].get<double>(), mean - 1e-7);
    EXPECT_NEAR(std::stod(fluxes.at("face,floor")[4]), -std::stod(fluxes.at("face,ceiling")[4]), 1e-6);
  }
}

TEST(Insulated, BoundsOfTemperaturesAreAsNarrowAsThoseOfRadiosities) {
  const Workplace place;
  place.write("room.json", kSquare);
  ASSERT_EQ(place.run("hottel solve room.json -o out --no-illumination --elements 8").code, 0);
  std::size_t count = 0;
  for (const std::string& line : lines_of(place.read("out/temperature.csv"))) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells[0] != "west") continue;
    ++count;
    EXPECT_LE(std::stod(cells[5]) - std::stod(cells[4]), 1e-12 * std::stod(cells[3])) << line;
  }
  EXPECT_EQ(count, 8u);
}

TEST(Insulated, IsReadBackAsItWasWrittenAndTheUnitToo) {
  for (const char* scene : {kSquare, kCube}) {
    const Workplace place;
    place.write("room.json", scene);
    ASSERT_EQ(place.run("hottel convert room.json once.json && hottel convert once.json twice.json").code, 0);
    EXPECT_THAT(place.read("once.json"), HasSubstr("\"wool\": {\"insulated\": true}"));
    EXPECT_THAT(place.read("once.json"), HasSubstr("\"unit\": \"ft\""));
    EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
  }
}

TEST(Insulated, IsRefusedBesideWhatItExcludes) {
  for (const char* other : {"\"reflectivity\": 1", "\"emission\": 0", "\"emissivity\": 0", "\"temperature\": 300"}) {
    const Workplace place;
    place.write("room.json", std::string("{\"hottel\": 1, \"dimension\": 2, \"materials\": {\n\"wool\": "
                                         "{\"insulated\": true, ") +
                                 other + "}}}");
    const Outcome outcome = place.run("hottel solve room.json");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("room.json:2: material 'wool' is insulated, which is reflectivity 1"));
  }
}

// Nothing decides how warm a room is that nothing leaves or enters: the limit of ever less emission is told.
TEST(Insulated, RoomOfNothingElseHasTheLimitZeroAndANote) {
  const Workplace place;
  std::string text = kSquare;
  for (const char* other : {"\"hot\"}", "\"cold\"}"})
    for (std::size_t at; (at = text.find(std::string("\"material\": ") + other)) != std::string::npos;)
      text.replace(at + 12, std::string(other).size() - 1, "\"wool\"");
  place.write("room.json", text);
  const Outcome outcome = place.run("hottel solve room.json -o out --no-illumination");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("note: "));
  EXPECT_EQ(table(place.read("out/temperature.csv"), 1).at("west")[3], "0");
}

TEST(Insulated, IsAQuantityOfPictures) {
  const Workplace place;
  place.write("room.json", kSquare);
  const Outcome outcome = place.run("hottel solve room.json -o out --show temperature --grid 4x4");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json report = Json::parse(place.read("out/report.json"));
  EXPECT_EQ(report["picture"]["lower"], 300);
  EXPECT_EQ(report["picture"]["upper"], 400);
}

}  // namespace
}  // namespace hottel::heat_test
