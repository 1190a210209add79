// Two bands, solar and thermal: closed forms in the plane and in space, energy by band, what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/black_power.h"
#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::bands_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::power_of;
using testing_cli::table;
using testing_cli::temperature_of;
using testing_cli::Workplace;
using Json = nlohmann::json;

// A plate on the ground under a sky that shines and is cold; what it gains it gives back to the sky. `plate`: the
// members of its material but "solar".
std::string plate_under_sky(int dimension, const std::string& plate, double rho, double shine) {
  const std::string shape =
      dimension == 2
          ? R"("edges": [{"name": "plate", "points": [[1, 0], [0, 0]], "material": "plate"}])"
          : R"("polygons": [{"name": "plate", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "plate"}])";
  return fmt::format(R"({{"hottel": 1, "dimension": {}, "materials": {{
  "plate": {{{}, "solar": {{"reflectivity": {}}}}}}},
  "sky": {{"temperature": 250, "solar": {{"emission": {}}}}},
  {}}})",
                     dimension, plate, rho, shine, shape);
}

// The plate sees nothing but the sky: H_s = S, H_t = sigma 250⁴; a = (1 - rho) S, B = q + a + H_t.
TEST(TwoBands, PlateUnderTheSkyComesToTheTemperatureOfItsBalance) {
  const double h = power_of(250);
  for (const int dimension : {2, 3})
    for (const auto& [plate, e, q] : {std::tuple(R"("insulated": true, "emissivity": 0.9)", 0.9, 0.0),
                                      {R"("emissivity": 0.8, "flux": -60)", 0.8, -60.0},
                                      {R"("emissivity": 0.5, "flux": 100)", 0.5, 100.0}}) {
      const Workplace place;
      place.write("plate.json", plate_under_sky(dimension, plate, 0.25, 600));
      const Outcome outcome = place.run("hottel solve plate.json -o out --no-picture");
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      const double a = 0.75 * 600, b = q + a + h, t = temperature_of(b + (1 - e) * (q + a) / e);
      const auto rows = table(place.read("out/temperature.csv"), 1);
      const auto& row = rows.at("plate");
      EXPECT_EQ(row[2], "thermal");
      EXPECT_NEAR(std::stod(row[3]), t, 1e-9);
      EXPECT_LE(std::stod(row[4]), std::stod(row[3]));
      EXPECT_GE(std::stod(row[5]), std::stod(row[3]));
      EXPECT_LE(std::stod(row[5]) - std::stod(row[4]), 1e-10);
      const auto radiosities = table(place.read("out/radiosity.csv"), 3);
      EXPECT_NEAR(std::stod(radiosities.at("plate,0,solar")[6]), 150, 1e-12);
      EXPECT_NEAR(std::stod(radiosities.at("plate,0,thermal")[6]), b, 1e-9);
      const auto fluxes = table(place.read("out/flux.csv"), 3);
      EXPECT_NEAR(std::stod(fluxes.at("face,plate,solar")[4]), -a, 1e-9);
      EXPECT_NEAR(std::stod(fluxes.at("face,plate,thermal")[4]), q + a, 1e-9);
      EXPECT_NEAR(std::stod(fluxes.at("face,plate,total")[4]), q, 1e-9);
      EXPECT_LE(std::stod(fluxes.at("face,plate,total")[5]), q);
      EXPECT_GE(std::stod(fluxes.at("face,plate,total")[6]), q);
      const Json energy = Json::parse(place.read("out/report.json"))["energy"];
      for (const char* band : {"solar", "thermal"})
        EXPECT_NEAR(energy[band]["emitted"].get<double>(),
                    energy[band]["absorbed"].get<double>() + energy[band]["to_sky"].get<double>(), 1e-8);
      EXPECT_NEAR(energy["solar"]["absorbed"].get<double>(), a, 1e-9);
    }
}

// Two long plates: of a duct with a square section the floor shines in the solar band, the ceiling is insulated, the
// sides are white in it and insulated. H_s of the ceiling by hand: B_f = 100, F = sqrt(2) - 1 straight, sides white.
TEST(TwoBands, InsulatedCeilingOfADuctGivesBackWhatItGains) {
  const Workplace place;
  place.write("duct.json", R"({"hottel": 1, "dimension": 2, "closed": true, "materials": {
  "floor": {"emissivity": 1, "temperature": 300, "solar": {"emission": 100}},
  "ceiling": {"insulated": true, "emissivity": "1/2", "solar": {"reflectivity": "1/5"}},
  "side": {"insulated": true, "solar": {"reflectivity": 1}}}, "edges": [
  {"name": "floor", "points": [[1, 0], [0, 0]], "material": "floor"},
  {"name": "west", "points": [[0, 0], [0, 1]], "material": "side"},
  {"name": "ceiling", "points": [[0, 1], [1, 1]], "material": "ceiling"},
  {"name": "east", "points": [[1, 1], [1, 0]], "material": "side"}]})");
  const Outcome outcome = place.run("hottel solve duct.json -o out --no-illumination");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("energy in the solar band: emitted 100"), HasSubstr("two bands"),
                                 Not(HasSubstr("say nothing"))));
  // Sides pass on what they receive: floor and ceiling exchange by F = (1 + sqrt(2) - 1) / 2.
  const double f = std::sqrt(2.0) / 2, h = f * 100 / (1 - (1 - f) * 0.2), gain = 0.8 * h;
  // What the ceiling gains goes to the floor by the same F, from B_c: B_c - sigma 300⁴ = gain / F.
  const double b = power_of(300) + gain / f, t = temperature_of(b + gain);
  EXPECT_NEAR(std::stod(table(place.read("out/temperature.csv"), 1).at("ceiling")[3]), t, 1e-9);
  const auto fluxes = table(place.read("out/flux.csv"), 3);
  EXPECT_NEAR(std::stod(fluxes.at("face,ceiling,total")[4]), 0, 1e-11);
  EXPECT_NEAR(std::stod(fluxes.at("face,ceiling,solar")[4]), -gain, 1e-11);
  EXPECT_EQ(std::stod(fluxes.at("face,west,total")[4]), 0);
  for (const char* band : {"solar", "thermal"}) {
    double sum = 0, lower = 0, upper = 0;
    for (const char* face : {"floor", "west", "ceiling", "east"}) {
      const auto& row = fluxes.at(fmt::format("face,{},{}", face, band));
      sum += std::stod(row[4]), lower += std::stod(row[5]), upper += std::stod(row[6]);
    }
    EXPECT_NEAR(sum, 0, 1e-11) << band;
    EXPECT_LE(lower, 0) << band;
    EXPECT_GE(upper, 0) << band;
  }
}

// The same of a cube, whose factors are enclosed: F = (1 + F12) / 2. The bounds are of both bands together.
TEST(TwoBands, InsulatedCeilingOfACubeHasItsTemperatureWithinTheBounds) {
  constexpr double kF12 = 0.19982489569838746;
  const Workplace place;
  place.write("cube.json", R"({"hottel": 1, "dimension": 3, "closed": true, "materials": {
  "floor": {"emissivity": 1, "temperature": 300, "solar": {"emission": 100}},
  "ceiling": {"emissivity": "1/2", "flux": -20, "solar": {"reflectivity": "1/5"}},
  "side": {"insulated": true, "solar": {"reflectivity": 1}}}, "polygons": [
  {"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "floor"},
  {"name": "ceiling", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "ceiling"},
  {"name": "west", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "side"},
  {"name": "east", "points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "side"},
  {"name": "south", "points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "side"},
  {"name": "north", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "side"}]})");
  const Outcome outcome = place.run("hottel solve cube.json -o out --no-picture");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(place.read("out/report.json"))["bounds"]["guarantee"], "enclosed");
  const double f = (1 + kF12) / 2, h = f * 100 / (1 - (1 - f) * 0.2), net = 0.8 * h - 20;
  const double expected = temperature_of(power_of(300) + net / f + net);
  const auto rows = table(place.read("out/temperature.csv"), 1);
  const auto& row = rows.at("ceiling");
  EXPECT_NEAR(std::stod(row[3]), expected, 1e-6);
  EXPECT_LE(std::stod(row[4]), expected + 1e-12);
  EXPECT_GE(std::stod(row[5]), expected - 1e-12);
  EXPECT_LE(std::stod(row[5]) - std::stod(row[4]), 1e-5);
  const auto fluxes = table(place.read("out/flux.csv"), 3);
  EXPECT_LE(std::stod(fluxes.at("face,ceiling,total")[5]), -20);
  EXPECT_GE(std::stod(fluxes.at("face,ceiling,total")[6]), -20);
}

TEST(TwoBands, LightsAreSolarUnlessTheySayThermal) {
  for (const bool is_thermal : {false, true}) {
    const Workplace place;
    place.write("room.json", fmt::format(R"({{"hottel": 1, "dimension": 2, "materials": {{
    "m": {{"emissivity": 1, "temperature": 300, "solar": {{"reflectivity": 0}}}}, "other": {{"emissivity": 1}}}}, "edges": [
    {{"name": "floor", "points": [[1, 0], [0, 0]], "material": "m"}},
    {{"name": "wall", "points": [[0, 0], [0, 1]], "material": "other"}}],
    "lights": [{{"type": "point", "name": "lamp", "position": [0.5, 1], "power": 10{}}}]}})",
                                         is_thermal ? R"(, "band": "thermal")" : ""));
    const Outcome outcome = place.run("hottel solve room.json -o out --grid 8x8");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("note: black in the solar band, of which they say nothing: 'other'"));
    const auto fluxes = table(place.read("out/flux.csv"), 3);
    EXPECT_EQ(std::stod(fluxes.at("light,lamp,solar")[4]), is_thermal ? 0 : 10);
    EXPECT_EQ(std::stod(fluxes.at("light,lamp,thermal")[4]), is_thermal ? 10 : 0);
    const Json sidecar = Json::parse(place.read("out/illumination.npy.json"));
    EXPECT_EQ(sidecar["channels"], Json::parse(R"(["solar", "thermal"])"));
    EXPECT_EQ(sidecar["shape"], Json::parse("[8, 8, 2]"));
    ASSERT_EQ(place.run("hottel convert room.json once.json && hottel convert once.json twice.json").code, 0);
    EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
    EXPECT_EQ(place.read("once.json").find("\"band\": \"thermal\"") != std::string::npos, is_thermal);
  }
}

TEST(TwoBands, AreKeptByConvert) {
  for (const int dimension : {2, 3}) {
    const Workplace place;
    place.write("plate.json", plate_under_sky(dimension, R"("insulated": true, "emissivity": 0.9)", 0.25, 600));
    ASSERT_EQ(place.run("hottel convert plate.json once.json && hottel convert once.json twice.json").code, 0);
    EXPECT_THAT(place.read("once.json"),
                AllOf(HasSubstr(R"("plate": {"insulated": true, "emissivity": 0.9, "solar": {"reflectivity": 0.25}})"),
                      HasSubstr(R"("sky": {"temperature": 250, "solar": {"emission": 600}})")));
    EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
  }
}

TEST(TwoBands, InsulatedFaceThatGainsNeedsAnEmissivity) {
  const Workplace place;
  place.write("plate.json", plate_under_sky(2, R"("insulated": true)", 0.25, 600));
  const Outcome outcome = place.run("hottel solve plate.json -o out --no-illumination");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("plate.json:"), HasSubstr("'plate' is insulated and gains light")));
  const Outcome check = place.run("hottel check plate.json");
  EXPECT_EQ(check.code, 1);
  EXPECT_THAT(check.out + check.err, HasSubstr("'plate' is insulated and gains light"));
  for (const auto& [rho, shine] : {std::pair(1.0, 600.0), {0.25, 0.0}}) {  // nothing is gained
    place.write("plate.json", plate_under_sky(2, R"("insulated": true)", rho, shine));
    ASSERT_EQ(place.run("hottel solve plate.json -o out --no-illumination").code, 0);
    EXPECT_NEAR(std::stod(table(place.read("out/temperature.csv"), 1).at("plate")[3]), 250, 1e-9);
  }
}

TEST(TwoBands, AreRefusedBesideWhatTheyExclude) {
  const auto scene = [](const std::string& members, const std::string& more) {
    return "{\"hottel\": 1, \"dimension\": 2, \"materials\": {\n\"m\": {" + members + "}}" + more + "}";
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {scene(R"("reflectivity": [0, 1, 0], "solar": {})", ""), "room.json:2: material 'm' has a list of three"},
      {scene(R"("solar": {"reflectivity": [0, 1, 0]})", ""), "material 'm': solar: reflectivity is one number"},
      {scene(R"("solar": {"reflectivity": 2})", ""), "must be from 0 to 1"},
      {scene(R"("solar": {"emission": -2})", ""), "must not be negative"},
      {scene(R"("solar": {"emissivity": 1})", ""), "emissivity"},
      {scene(R"("insulated": true, "emissivity": 0, "solar": {})", ""), "emissivity beside insulated must be above 0"},
      {scene("", R"(, "sky": {"solar": {"reflectivity": 1}})"), "sky: solar has an emission only"},
      {scene("", R"(, "sky": {"emission": [1, 2, 3], "solar": {"emission": 1}})"), "sky has a list of three"},
      {scene("", R"(, "lights": [{"type": "point", "position": [0, 0], "power": 1, "band": "solar"}])"),
       "light 'light[0]' has a band"},
      {scene(R"("solar": {})", R"(, "lights": [{"type": "point", "position": [0, 0], "power": 1, "band": "uv"}])"),
       "it may be \"solar\" or \"thermal\""},
      {scene(R"("solar": {})", R"(, "lights": [{"type": "point", "position": [0, 0], "power": [1, 2, 3]}])"),
       "light 'light[0]' has a list of three"}};
  for (const auto& [text, message] : cases) {
    const Workplace place;
    place.write("room.json", text);
    const Outcome outcome = place.run("hottel solve room.json");
    EXPECT_EQ(outcome.code, 3) << message;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("room.json:"), HasSubstr(message)));
  }
}

TEST(TwoBands, AreQuantitiesOfPicturesByBandOrTogether) {
  const Workplace place;
  place.write("plate.json", plate_under_sky(3, R"("insulated": true, "emissivity": 0.9)", 0.25, 600));
  place.write("plain.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emission": [1, 2, 3]}}, "polygons": [
    {"name": "plate", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"}]})");
  const double thermal = power_of(250) + 450;
  for (const auto& [words, value] : {std::pair("radiosity", 150 + thermal),
                                     {"radiosity --channel solar", 150.0},
                                     {"radiosity --channel thermal", thermal},
                                     {"temperature", temperature_of(thermal + 0.1 / 0.9 * 450)}}) {
    const Outcome outcome = place.run(fmt::format("hottel solve plate.json -o out --show {}", words));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(Json::parse(place.read("out/report.json"))["picture"]["upper"].get<double>(), value, 1e-6) << words;
  }
  EXPECT_EQ(place.run("hottel solve plate.json -o light").code, 0);
  EXPECT_EQ(place.run("hottel solve plate.json -o out --show radiosity --channel r").code, 2);
  EXPECT_EQ(place.run("hottel solve plain.json -o out --show radiosity --channel solar").code, 2);
}

TEST(TwoBands, ScriptFIsThermal) {
  const Workplace place;
  place.write("plate.json", plate_under_sky(2, R"("emissivity": 0.7, "temperature": 280)", 0.25, 600));
  EXPECT_THAT(place.run("hottel factors plate.json --script-f --quiet").out, HasSubstr("plate,sky,0.7,"));
}

}  // namespace
}  // namespace hottel::bands_test
