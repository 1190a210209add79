// Faces of given net flux: closed forms in the plane and in space, what has no solution, what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/black_power.h"
#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::given_flux_cli_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing_cli::Outcome;
using testing_cli::power_of;
using testing_cli::table;
using testing_cli::temperature_of;
using testing_cli::Workplace;
using Json = nlohmann::json;

// A right triangle with legs 3 and 4: s1 (4) is at 300 K, s2 (3) and s3 (5) have net fluxes.
std::string triangle(double q2, double q3) {
  return fmt::format(R"({{"hottel": 1, "dimension": 2, "closed": true, "materials": {{
  "one": {{"emissivity": "0.4", "temperature": 300}},
  "two": {{"emissivity": "0.6", "flux": {}}},
  "three": {{"emissivity": "0.8", "flux": {}}}}}, "edges": [
  {{"name": "s1", "points": [[4, 0], [0, 0]], "material": "one"}},
  {{"name": "s2", "points": [[0, 0], [0, 3]], "material": "two"}},
  {{"name": "s3", "points": [[0, 3], [4, 0]], "material": "three"}}]}})",
                     q2, q3);
}

// By hand: what s1 takes is what the others give, so B1 is known; of two equations the others follow.
std::pair<double, double> temperatures_of_triangle(double q2, double q3) {
  const double f12 = (4.0 + 3 - 5) / 8, f13 = 1 - f12, f21 = f12 * 4 / 3, f23 = 1 - f21, f31 = f13 * 4 / 5,
               f32 = f23 * 3 / 5;
  (void)f13;
  const double q1 = -(3 * q2 + 5 * q3) / 4, b1 = power_of(300) - 0.6 / 0.4 * q1;
  // B2 = q2 + F21 B1 + F23 B3, B3 = q3 + F31 B1 + F32 B2.
  const double c2 = q2 + f21 * b1, c3 = q3 + f31 * b1, b2 = (c2 + f23 * c3) / (1 - f23 * f32), b3 = c3 + f32 * b2;
  return {temperature_of(b2 + 0.4 / 0.6 * q2), temperature_of(b3 + 0.2 / 0.8 * q3)};
}

TEST(GivenFlux, TriangleComesToTheTemperaturesOfTheClosedForm) {
  for (const auto& [q2, q3] : {std::pair(2000.0, 1000.0), {-40.0, 150.0}, {-30.0, -20.0}, {0.0, 500.0}}) {
    const auto [t2, t3] = temperatures_of_triangle(q2, q3);
    const Workplace place;
    place.write("room.json", triangle(q2, q3));
    const Outcome outcome = place.run("hottel solve room.json -o out --no-illumination");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto temperatures = table(place.read("out/temperature.csv"), 1),
               fluxes = table(place.read("out/flux.csv"), 2);
    for (const auto& [face, expected] : {std::pair("s2", t2), {"s3", t3}}) {
      const auto& row = temperatures.at(face);
      EXPECT_NEAR(std::stod(row[3]), expected, 1e-9 * expected) << q2;
      EXPECT_LE(std::stod(row[4]), std::stod(row[3]));
      EXPECT_GE(std::stod(row[5]), std::stod(row[3]));
      EXPECT_LE(std::stod(row[5]) - std::stod(row[4]), 1e-10);
    }
    EXPECT_NEAR(std::stod(fluxes.at("face,s2")[4]), 3 * q2, 1e-9);
    EXPECT_NEAR(std::stod(fluxes.at("face,s1")[4]), -3 * q2 - 5 * q3, 1e-8);
    const Json report = Json::parse(place.read("out/report.json"));
    EXPECT_EQ(report["given_flux"][0]["name"], "s2");
    EXPECT_NEAR(report["given_flux"][1]["coldest"].get<double>(), t3, 1e-9 * t3);
    const Json& energy = report["energy"];
    EXPECT_NEAR(energy["emitted"].get<double>(),
                4 * 0.4 * power_of(300) + 3 * std::max(q2, 0.0) + 5 * std::max(q3, 0.0), 1e-8);
    EXPECT_NEAR(energy["defect"].get<double>(), 0, 1e-8);
  }
  EXPECT_NEAR(temperatures_of_triangle(2000, 1000).first, 640.7, 0.05);
  EXPECT_NEAR(temperatures_of_triangle(2000, 1000).second, 598.8, 0.05);
}

// A cube: floor at 400 K, a flux through the ceiling, insulated sides: a network of three surfaces. Sides reradiate:
// between floor and ceiling F12 + (1 - F12) / 2, F12 of opposite faces of a cube.
TEST(GivenFlux, CeilingOfACubeComesToTheTemperatureOfTheNetwork) {
  constexpr double kF12 = 0.19982489569838746;
  for (const double flux : {800.0, -200.0}) {
    const Workplace place;
    place.write("room.json", fmt::format(R"({{"hottel": 1, "dimension": 3, "closed": true, "materials": {{
  "hot": {{"emissivity": "0.5", "temperature": 400}}, "given": {{"emissivity": "0.25", "flux": {}}},
  "wool": {{"insulated": true}}}}, "polygons": [
  {{"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "hot"}},
  {{"name": "ceiling", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "given"}},
  {{"name": "west", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "wool"}},
  {{"name": "east", "points": [[1,0,0],[1,0,1],[1,1,1],[1,1,0]], "material": "wool"}},
  {{"name": "south", "points": [[0,0,0],[0,0,1],[1,0,1],[1,0,0]], "material": "wool"}},
  {{"name": "north", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "wool"}}]}})",
                                         flux));
    const Outcome outcome = place.run("hottel solve room.json -o out --no-picture");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const double resistance = (1 - 0.5) / 0.5 + 1 / ((1 + kF12) / 2) + (1 - 0.25) / 0.25;
    const auto row = table(place.read("out/temperature.csv"), 1).at("ceiling");
    const double expected = temperature_of(power_of(400) + flux * resistance);
    EXPECT_NEAR(std::stod(row[3]), expected, 1e-6);
    EXPECT_LE(std::stod(row[4]), expected + 1e-9);
    EXPECT_GE(std::stod(row[5]), expected - 1e-9);
    EXPECT_NEAR(std::stod(table(place.read("out/flux.csv"), 2).at("face,floor")[4]), -flux, 1e-5);
  }
}

TEST(GivenFlux, RoomThatLosesNothingIsRefusedBalancedOrNot) {
  for (const auto& [q2, q3] : {std::pair(20, 10), {-50, 30}}) {
    const Workplace place;
    std::string text = triangle(q2, q3);
    text.replace(text.find(R"("temperature": 300)"), 18, R"("flux": 0)");
    place.write("room.json", text);
    const Outcome outcome = place.run("hottel solve room.json -o out --no-illumination");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("room.json"), HasSubstr("no temperatures: 's1' and what it exchanges light "
                                                        "with (3 elements in all)")));
    EXPECT_FALSE(std::filesystem::exists(place.path("out/radiosity.csv")));
    const Outcome check = place.run("hottel check room.json");
    EXPECT_EQ(check.code, 1);
    EXPECT_THAT(check.out + check.err, HasSubstr("there are no temperatures for it"));
  }
  const Workplace place;
  std::string text = triangle(0, 0);
  text.replace(text.find(R"("temperature": 300)"), 18, R"("flux": 0)");
  place.write("room.json", text);
  ASSERT_EQ(place.run("hottel solve room.json -o out --no-illumination").code, 0);
  EXPECT_EQ(table(place.read("out/temperature.csv"), 1).at("s2")[3], "0");
}

TEST(GivenFlux, FaceThatWouldBeColderThanNothingIsRefusedByName) {
  const Workplace place;
  place.write("room.json", triangle(-2000, 1000));
  const Outcome outcome = place.run("hottel solve room.json -o out --no-illumination");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("room.json:6: no temperature: 's2' would have to be colder than 0 K"));
  const Outcome check = place.run("hottel check room.json");
  EXPECT_EQ(check.code, 1);
  EXPECT_THAT(check.out + check.err, HasSubstr("'s2' would have to be colder than 0 K"));
}

TEST(GivenFlux, IsRefusedBesideWhatItExcludes) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"("flux": 1)", "has a flux but no emissivity"},
      {R"("flux": 1, "emissivity": 0)", "emissivity beside flux must be above 0"},
      {R"("flux": 1, "emissivity": "5/4")", "emissivity beside flux must be above 0"},
      {R"("flux": 1, "emissivity": 1, "temperature": 3)", "has a temperature and a flux"},
      {R"("flux": 1, "emissivity": [1, 1, 1])", "emissivity is one number"},
      {R"("flux": [1, 1, 1], "emissivity": 1)", "flux is one number"},
      {R"("flux": true, "emissivity": 1)", "flux"},
      {R"("flux": 1, "reflectivity": 1)", "has a flux beside reflectivity or emission"},
      {R"("flux": 1, "insulated": true)", "is insulated"}};
  for (const auto& [members, message] : cases)
    for (const char* dimension : {"2", "3"}) {
      const Workplace place;
      place.write("room.json", std::string("{\"hottel\": 1, \"dimension\": ") + dimension +
                                   ", \"materials\": {\n\"m\": {" + members + "}}}");
      const Outcome outcome = place.run("hottel solve room.json");
      EXPECT_EQ(outcome.code, 3) << members;
      EXPECT_THAT(outcome.err, AllOf(HasSubstr("room.json:2: material 'm'"), HasSubstr(message)));
    }
}

TEST(GivenFlux, IsKeptByConvertAndScriptFHasTheEmissivityOfTheSurface) {
  const Workplace place;
  place.write("room.json", triangle(-40.5, 1000));
  ASSERT_EQ(place.run("hottel convert room.json once.json && hottel convert once.json twice.json").code, 0);
  EXPECT_THAT(place.read("once.json"), HasSubstr(R"("two": {"emissivity": 0.6, "flux": -40.5})"));
  EXPECT_EQ(place.read("once.json"), place.read("twice.json"));
  std::string warm = triangle(-40.5, 1000);
  for (const char* flux : {R"("flux": -40.5)", R"("flux": 1000)"})
    warm.replace(warm.find(flux), std::string(flux).size(), R"("temperature": 300)");
  place.write("warm.json", warm);
  EXPECT_EQ(place.run("hottel factors room.json --script-f --quiet").out,
            place.run("hottel factors warm.json --script-f --quiet").out);
}

TEST(GivenFlux, MeshFilesHaveTheReflectivityOfTheSurfaceAndSayWhatTheyLack) {
  const Workplace place;
  place.write("plate.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emissivity": "0.75", "flux": 3}},
    "polygons": [{"name": "plate", "points": [[0,0,0],[1,0,0],[0,1,0]], "material": "m"}]})");
  const Outcome outcome = place.run("hottel convert plate.json plate.obj");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the net fluxes of these materials are not written, only how they reflect: 'm'"));
  EXPECT_THAT(place.read("plate.mtl"), AllOf(HasSubstr("Kd 0.25 0.25 0.25"), testing::Not(HasSubstr("Ke"))));
}

TEST(GivenFlux, IsAQuantityOfPictures) {
  const Workplace place;
  place.write("room.json", triangle(2000, 1000));
  for (const auto& [quantity, most] :
       {std::pair("temperature", temperatures_of_triangle(2000, 1000).first), {"net", 2000.0}}) {
    ASSERT_EQ(place.run(std::string("hottel solve room.json -o out --grid 4x4 --show ") + quantity).code, 0);
    EXPECT_NEAR(Json::parse(place.read("out/report.json"))["picture"]["upper"].get<double>(), most, 1e-6);
  }
}

}  // namespace
}  // namespace hottel::given_flux_cli_test
