// Suns as users meet them: radiosities and temperatures by hand, grids, the energy, a day in frames, what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "tests/cli/black_power.h"
#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::sun_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::power_of;
using testing_cli::table;
using testing_cli::temperature_of;
using testing_cli::Workplace;
using Json = nlohmann::json;

// Ground of 10 and a black wall of height 3 on it, with a grid of cells of 1.
std::string yard(const std::string& lights) {
  return R"({ "hottel": 1, "dimension": 2, "materials": {"ground": {}, "wall": {}},
  "edges": [{"name": "ground", "points": [[10,0],[0,0]], "material": "ground", "elements": 5},
            {"name": "wall", "points": [[4,0],[4,3]], "material": "wall", "back": "wall"}],
  "grid": {"min": [0,0], "max": [10,4], "cells": [10,4]},
  "lights": [)" +
         lights + "] }";
}

// Ground of 10 x 10 and a wall across it at x = 4.
std::string court(const std::string& lights) {
  return R"({ "hottel": 1, "dimension": 3, "materials": {"ground": {"reflectivity": 0.5}, "wall": {}},
  "polygons": [{"name": "ground", "points": [[0,0,0],[10,0,0],[10,10,0],[0,10,0]], "material": "ground"},
               {"name": "wall", "points": [[4,0,0],[4,10,0],[4,10,3],[4,0,3]], "material": "wall", "back": "wall"}],
  "grid": {"origin": [0,5,0], "u": [10,0,0], "v": [0,0,4], "cells": [10,4]},
  "lights": [)" +
         lights + "] }";
}

const std::string kSun = R"({"type": "sun", "name": "sun", "direction": [4, -3], "irradiance": 500})";
const std::string kSun3 = R"({"type": "sun", "name": "sun", "direction": [4, 0, -3], "irradiance": [500, 50, 5]})";

std::vector<double> doubles_of(const std::string& npy, std::size_t count) {
  std::vector<double> values(count);
  std::memcpy(values.data(), npy.data() + npy.size() - 8 * count, 8 * count);
  return values;
}

TEST(Sun, LightsFacesAndCellsAndItsEnergyIsWhatMeetsFaces) {
  const Workplace place;
  place.write("yard.json", yard(kSun));
  const Outcome outcome = place.run("hottel solve yard.json -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("of the sun only what meets faces is counted"));
  const auto rows = table(place.read("out/radiosity.csv"), 2);
  for (const auto& [element, irradiance] : {std::pair("0", 300.0), {"1", 0.0}, {"2", 0.0}, {"3", 300.0}, {"4", 300.0}})
    EXPECT_NEAR(std::stod(rows.at(std::string("ground,") + element)[9]), irradiance, 1e-12) << element;
  EXPECT_NEAR(std::stod(rows.at("wall:back,0")[9]), 400, 1e-12);
  EXPECT_EQ(std::stod(rows.at("wall,0")[9]), 0);
  const Json energy = Json::parse(place.read("out/report.json"))["energy"];
  EXPECT_NEAR(energy["emitted"], 3000, 1e-11);  // 10 of ground times 300: what the wall takes the ground lacks
  EXPECT_NEAR(energy["absorbed"], 3000, 1e-11);
  EXPECT_EQ(energy["to_sky"], 0);
  ASSERT_TRUE(energy.contains("passed"));
  EXPECT_TRUE(energy["passed"].is_null());
  EXPECT_NEAR(std::stod(table(place.read("out/flux.csv"), 2).at("light,sun")[4]), 3000, 1e-11);

  // E / pi where it shines, before and behind the shadow, which falls by 3 on 4.
  const std::vector<double> grid = doubles_of(place.read("out/illumination.npy"), 40);
  const double full = 500 / std::numbers::pi;
  for (int iy = 0; iy < 4; ++iy)
    for (int ix = 0; ix < 10; ++ix) {
      const double x = ix + 0.5, y = iy + 0.5;
      const bool is_lit = x < 4 || y > 3 - 0.75 * (x - 4);
      EXPECT_NEAR(grid[static_cast<std::size_t>(10 * iy + ix)], is_lit ? full : 0, 1e-12) << x << " " << y;
    }
}

TEST(Sun, HasChannelsAndLightsSpace) {
  const Workplace place;
  place.write("court.json", court(kSun3));
  const Outcome outcome = place.run("hottel solve court.json -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = table(place.read("out/radiosity.csv"), 3);
  // The black wall reflects nothing: the ground gets the sun on 60 of its 100 m² alone.
  for (const auto& [channel, e] : {std::pair("r", 500.0), {"g", 50.0}, {"b", 5.0}}) {
    EXPECT_NEAR(std::stod(rows.at(std::string("ground,0,") + channel)[9]), e * 0.6 * 0.6, 1e-11);
    EXPECT_NEAR(std::stod(rows.at(std::string("ground,0,") + channel)[6]), e * 0.6 * 0.6 / 2, 1e-11);
  }
  const Json energy = Json::parse(place.read("out/report.json"))["energy"];
  EXPECT_NEAR(energy["emitted"], 555 * 60, 1e-8);
  EXPECT_TRUE(energy.at("passed").is_null());
  EXPECT_NEAR(energy["defect"], 0, 1e-9);

  place.write("black.json", court(R"({"type": "sun", "direction": [4, 0, -3], "irradiance": 500})")
                                .replace(court("").find("\"reflectivity\": 0.5"), 19, ""));
  ASSERT_EQ(place.run("hottel solve black.json -o black").code, 0);
  const std::vector<double> grid = doubles_of(place.read("black/illumination.npy"), 40);
  for (int iv = 0; iv < 4; ++iv)
    for (int iu = 0; iu < 10; ++iu) {
      const double x = iu + 0.5, z = iv + 0.5;
      const bool is_lit = x < 4 || z > 3 - 0.75 * (x - 4);
      EXPECT_EQ(grid[static_cast<std::size_t>(10 * iv + iu)], is_lit ? 125 : 0) << x << " " << z;
    }
}

// A plate that gains (1 - rho) E cos from the sun, and nothing else, and gives it back: as a plate under a sky that
// shines.
TEST(Sun, ShinesInTheSolarBandAndHeats) {
  for (const int dimension : {2, 3}) {
    const Workplace place;
    place.write(
        "plate.json",
        fmt::format(R"({{"hottel": 1, "dimension": {}, "materials": {{
  "plate": {{"insulated": true, "emissivity": 0.9, "solar": {{"reflectivity": 0.25}}}}}},
  "sky": {{"temperature": 250}}, {},
  "lights": [{{"type": "sun", "direction": {}, "irradiance": 800}}]}})",
                    dimension,
                    dimension == 2 ? R"("edges": [{"name": "plate", "points": [[1, 0], [0, 0]], "material": "plate"}])"
                                   : R"("polygons": [{"name": "plate", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]],
                                "material": "plate"}])",
                    dimension == 2 ? "[3, -4]" : "[3, 0, -4]"));
    const Outcome outcome = place.run("hottel solve plate.json -o out --no-picture");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const double a = 0.75 * 800 * 0.8, t = temperature_of(power_of(250) + a / 0.9);
    const auto row = table(place.read("out/temperature.csv"), 1).at("plate");
    EXPECT_NEAR(std::stod(row[3]), t, 1e-9);
    EXPECT_LE(std::stod(row[4]), std::stod(row[3]));
    const Json energy = Json::parse(place.read("out/report.json"))["energy"];
    EXPECT_NEAR(energy["solar"]["emitted"], 640, 1e-11);
    EXPECT_NEAR(energy["solar"]["to_sky"], 160, 1e-11);
    EXPECT_TRUE(energy["solar"].contains("passed"));
    EXPECT_FALSE(energy["thermal"].contains("passed"));
    const auto flux = table(place.read("out/flux.csv"), 3);
    EXPECT_NEAR(std::stod(flux.at("face,plate,total")[4]), 0, 1e-9);
    EXPECT_NEAR(std::stod(flux.at("light,light[0],solar")[4]), 640, 1e-9);
  }
}

TEST(Sun, OtherWordsAreRefused) {
  const Workplace place;
  const auto with = [](const std::string& more) {
    return R"({"type": "sun", "direction": [4, -3], "irradiance": 500, )" + more + "}";
  };
  for (const auto& [light, text] :
       {std::pair(with(R"("focus": 20)"), "is a sun, infinitely far away: it has no focus"),
        {with(R"("falloff": 1)"), "it has no falloff"},
        {with(R"("position": [1, 1])"), "it has no position"},
        {with(R"("power": 3)"), "it has no power"},
        {with(R"("path": {"points": [[0,0],[1,0]], "seconds": 3})"), "it has no path"},
        {with(R"("band": "solar")"), "has a band, and the scene no two"},
        {R"({"type": "sun", "direction": [0, 0], "irradiance": 500})", "shines nowhere: its direction is zero"},
        {R"({"type": "sun", "direction": [1, 0], "irradiance": -1})", "irradiance"},
        {R"({"type": "sun", "direction": [1, 0]})", "irradiance"},
        {R"({"type": "sun", "irradiance": 3})", "direction"},
        {R"({"type": "point", "position": [1, 1], "power": 3, "irradiance": 3})", "is no sun: it has no irradiance"},
        {R"({"type": "star", "position": [1, 1], "power": 3})", R"(it may be "point", "spot" or "sun")"}}) {
    place.write("yard.json", yard(light));
    const Outcome outcome = place.run("hottel solve yard.json -o out");
    EXPECT_EQ(outcome.code, 3) << light;
    EXPECT_THAT(outcome.err, HasSubstr("yard.json:")) << light;
    EXPECT_THAT(outcome.err, HasSubstr(text)) << light;
  }
  place.write("court.json", court(R"({"type": "sun", "direction": [0, 0, 0], "irradiance": 500})"));
  EXPECT_EQ(place.run("hottel plan court.json").code, 3);
  place.write("yard.json", yard(kSun + ", " + kSun));
  EXPECT_THAT(place.run("hottel solve yard.json -o out").err, HasSubstr("two lights have the name 'sun'"));
}

TEST(Sun, IsKeptByConvertToldByPlanAndPassesTheCheck) {
  const Workplace place;
  place.write("yard.json", yard(R"({"type": "sun", "name": "sun", "direction": ["1/3", -2], "irradiance": 500,
    "rotation": 15}, {"type": "point", "name": "lamp", "position": [1, 1], "power": 2})"));
  place.write("court.json",
              court(R"({"type": "sun", "name": "sun", "direction": ["1/3", 0, -2], "irradiance": [1, 2, 3],
    "rotation": [0, 15, 0]})"));
  for (const std::string name : {"yard", "court"}) {
    ASSERT_EQ(place.run("hottel convert " + name + ".json once.json").code, 0);
    ASSERT_EQ(place.run("hottel convert once.json twice.json").code, 0);
    EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
    EXPECT_THAT(place.read("once.json"), HasSubstr(R"({"type": "sun", "name": "sun", "direction": ["1/3", )"));
    EXPECT_THAT(place.read("once.json"), HasSubstr("\"irradiance\": "));
    ASSERT_EQ(place.run("hottel solve " + name + ".json -o a --no-picture --no-illumination").code, 0);
    ASSERT_EQ(place.run("hottel solve once.json -o b --no-picture --no-illumination").code, 0);
    EXPECT_EQ(place.read("a/radiosity.csv"), place.read("b/radiosity.csv"));
    EXPECT_EQ(place.run("hottel check " + name + ".json").code, 0);
    const std::string plan = place.run("hottel plan " + name + ".json").out;
    EXPECT_THAT(plan, HasSubstr("1 sun among them"));
    EXPECT_THAT(plan, Not(HasSubstr("with a border")));
    EXPECT_THAT(plan, HasSubstr("lights turn or follow paths"));
  }
  place.write("dark.json", yard(""));
  EXPECT_THAT(place.run("hottel plan dark.json").out, Not(HasSubstr("sun")));
}

// The ground's back is black: from below nothing with a material is lit. One that turns may come.
TEST(Sun, ThatShinesOnNothingIsNoted) {
  const Workplace place;
  const auto note = [&](const std::string& scene) {
    place.write("scene.json", scene);
    const Outcome outcome = place.run("hottel check scene.json");
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    return outcome.out;
  };
  const std::string text = "light 'up' is a sun that shines on no face with a material";
  const std::string up = R"({"type": "sun", "name": "up", "direction": [0, 3], "irradiance": 5)";
  const std::string up_in_space = R"({"type": "sun", "name": "up", "direction": [0, 0, 3], "irradiance": 5)";
  EXPECT_THAT(note(yard(up + "}")), HasSubstr(text));
  EXPECT_THAT(note(yard(up + "}")), HasSubstr("dark-sun"));
  EXPECT_THAT(note(court(up_in_space + "}")), HasSubstr(text));
  EXPECT_THAT(note(yard(up + R"(, "rotation": 1})")), Not(HasSubstr(text)));
  EXPECT_THAT(note(court(up_in_space + R"(, "rotation": [1, 0, 0]})")), Not(HasSubstr(text)));
  EXPECT_THAT(note(yard(kSun)), Not(HasSubstr("dark-sun")));
  EXPECT_THAT(note(court(kSun3)), Not(HasSubstr("dark-sun")));
}

TEST(Sun, BordersOfItsShadowsDivideElements) {
  const Workplace place;
  for (const auto& [name, scene] : {std::pair("yard", yard(kSun)), {"court", court(kSun3)}}) {
    place.write("scene.json", scene);
    ASSERT_EQ(place.run("hottel solve scene.json -o whole --no-picture --no-illumination").code, 0);
    const Outcome outcome =
        place.run("hottel solve scene.json -o fine --light-levels 3 --no-picture --no-illumination");
    ASSERT_EQ(outcome.code, 0) << name << outcome.err;
    const auto energy = [&](const std::string& folder) {
      return Json::parse(place.read(folder + "/report.json"))["energy"]["emitted"].get<double>();
    };
    EXPECT_NEAR(energy("fine"), energy("whole"), 1e-9) << name;
  }
}

TEST(Sun, TestsOfPointsAreEstimates) {
  const Workplace place;
  place.write("yard.json", yard(kSun).replace(yard(kSun).find(R"(, "elements": 5)"), 15, ""));
  const Outcome outcome = place.run("hottel solve yard.json -o out --lights centroid");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  // The middle of the ground is in the shadow: of 3000 its 1800 are missing.
  EXPECT_THAT(outcome.err, HasSubstr("60 % of the power of the lights missing"));
  const Json energy = Json::parse(place.read("out/report.json"))["energy"];
  EXPECT_NEAR(energy["emitted"], 3000, 1e-9);
  EXPECT_NEAR(energy["absorbed"], 1200, 1e-9);
  EXPECT_NEAR(energy["defect"], 1800, 1e-9);
}

// A day in frames: the sun turns by 15 degrees in each of 24 hours, and comes back.
TEST(Sun, ADayIsAFilm) {
  const Workplace place;
  const std::string day = R"("irradiance": 500, "rotation": )";
  place.write("yard.json", yard(R"({"type": "sun", "direction": [0, 1], )" + day + "15}"));
  place.write("court.json", court(R"({"type": "sun", "direction": [0, 0, 1], )" + day + "[0, 15, 0]}"));
  for (const std::string name : {"yard", "court"}) {
    const Outcome outcome =
        place.run("hottel animate " + name + ".json --frames 25 --fps 1 --size 120 --no-film -o " + name);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto frame = [&](const char* number) { return place.read(name + "/frame_000" + number + ".png"); };
    EXPECT_EQ(frame("00"), frame("24"));
    EXPECT_NE(frame("09"), frame("12"));
    EXPECT_NE(frame("12"), frame("15"));
  }
}

TEST(Sun, IsSeenByPointsAndWindows) {
  const Workplace place;
  place.write("yard.json", yard(kSun));
  const auto light_at = [&](const std::string& at) {
    const Outcome outcome = place.run("hottel visibility yard.json --json --at " + at);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(light_at("1,1"), HasSubstr("159.15494309189"));
  EXPECT_THAT(light_at("5,1"), Not(HasSubstr("159.15494309189")));
  for (const auto& [name, scene] : {std::pair("yard", yard(kSun)), {"court", court(kSun3)}}) {
    place.write("scene.json", scene);
    const Outcome outcome = place.run("hottel view scene.json --screenshot shot.png");
    EXPECT_EQ(outcome.code, 0) << name << outcome.err;
    EXPECT_FALSE(place.read("shot.png").empty());
  }
}

}  // namespace
}  // namespace hottel::sun_test
