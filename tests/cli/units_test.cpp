// The unit of length of a scene: areas, fluxes and light of lamps are in SI, whatever coordinates are typed in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_cli::cells_of;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::table;
using testing_cli::Workplace;
using Json = nlohmann::json;

constexpr double kSigma = 5.670374419e-8;

// A unit, and how many of it are a metre: p / q.
struct Unit {
  const char* name;
  long p, q;
};
constexpr Unit kMetre{"m", 1, 1};
constexpr Unit kUnits[] = {{"mm", 1000, 1}, {"cm", 100, 1}, {"km", 1, 1000}, {"in", 5000, 127}, {"ft", 1250, 381}};

// A tenth of a metre, so many times, as a number of a scene.
std::string length(long tenths, const Unit& unit) {
  return '"' + std::to_string(tenths * unit.p) + "/" + std::to_string(10 * unit.q) + '"';
}
std::string point(std::initializer_list<long> tenths, const Unit& unit) {
  std::string text;
  for (const long some : tenths) text += (text.empty() ? "[" : ", ") + length(some, unit);
  return text + "]";
}

std::string head(int dimension, const Unit& unit) {
  return R"({"hottel": 1, "dimension": )" + std::to_string(dimension) + R"(, "unit": ")" + unit.name + R"(", )";
}

// One insulated edge of a metre, and a point light of 100 W/m half a metre above its middle.
std::string lamp(const Unit& unit) {
  return head(2, unit) + R"("materials": {"wool": {"insulated": true}},
    "edges": [{"name": "floor", "points": [)" +
         point({10, 0}, unit) + ", " + point({0, 0}, unit) + R"(], "material": "wool"}],
    "lights": [{"type": "point", "position": )" +
         point({5, 5}, unit) + R"(, "power": 100}]})";
}

constexpr const char* kMaterials = R"("materials": {"hot": {"emissivity": 0.8, "temperature": 400},
    "grey": {"emissivity": 0.5, "temperature": 250}, "wool": {"insulated": true},
    "heated": {"emissivity": 0.9, "flux": 70}}, "sky": {"temperature": 240}, )";

// An open room with something in it, a lamp, a beam and a sun, and a grid.
std::string room_2(const Unit& unit) {
  const auto edge = [&](const char* name, std::initializer_list<long> a, std::initializer_list<long> b,
                        const char* material) {
    return std::string(R"({"name": ")") + name + R"(", "points": [)" + point(a, unit) + ", " + point(b, unit) +
           R"(], "material": ")" + material + R"(", "back": "grey", "elements": 2})";
  };
  return head(2, unit) + kMaterials + R"("edges": [)" + edge("floor", {40, 0}, {0, 0}, "heated") + ",\n" +
         edge("west", {0, 0}, {0, 30}, "wool") + ",\n" + edge("east", {40, 30}, {40, 0}, "hot") + ",\n" +
         edge("screen", {10, 9}, {21, 17}, "grey") + R"(], "grid": {"min": )" + point({1, 1}, unit) + R"(, "max": )" +
         point({33, 29}, unit) + R"(, "cells": [3, 2]}, "lights": [
    {"type": "point", "position": )" +
         point({7, 20}, unit) + R"(, "power": 300},
    {"type": "spot", "position": )" +
         point({27, 22}, unit) + R"(, "direction": [-1, -3], "focus": 25, "falloff": 2, "power": 200},
    {"type": "sun", "direction": [1, -4], "irradiance": 500}]})";
}

std::string room_3(const Unit& unit) {
  const auto polygon = [&](const char* name, const std::vector<std::string>& points, const char* material) {
    std::string text = std::string(R"({"name": ")") + name + R"(", "points": [)";
    for (const std::string& some : points) text += (&some == points.data() ? "" : ", ") + some;
    return text + R"(], "material": ")" + material + R"(", "back": "grey"})";
  };
  const auto at = [&](long x, long y, long z) { return point({x, y, z}, unit); };
  return head(3, unit) + kMaterials + R"("polygons": [)" +
         polygon("floor", {at(0, 0, 0), at(40, 0, 0), at(40, 30, 0), at(0, 30, 0)}, "heated") + ",\n" +
         polygon("west", {at(0, 0, 0), at(0, 30, 0), at(0, 30, 20), at(0, 0, 20)}, "wool") + ",\n" +
         polygon("east", {at(40, 0, 0), at(40, 0, 20), at(40, 30, 20), at(40, 30, 0)}, "hot") + ",\n" +
         polygon("shelf", {at(10, 10, 9), at(24, 11, 9), at(17, 23, 9)}, "grey") + R"(], "grid": {"origin": )" +
         at(2, 3, 12) + R"(, "u": )" + at(31, 0, 0) + R"(, "v": )" + at(0, 23, 0) +
         R"(, "cells": [3, 2]}, "lights": [
    {"type": "point", "position": )" +
         at(7, 20, 15) + R"(, "power": 300},
    {"type": "spot", "position": )" +
         at(27, 22, 18) + R"(, "direction": [-1, 0, -3], "focus": 25, "falloff": 2, "power": 200},
    {"type": "sun", "direction": [1, 1, -4], "irradiance": 500}]})";
}

using Rows = std::vector<std::vector<std::string>>;
Rows rows_of(const std::string& csv) {
  Rows rows;
  for (const std::string& line : lines_of(csv)) rows.push_back(cells_of(line));
  return rows;
}

void expect_near(double found, double wanted, double scale, const std::string& where) {
  EXPECT_NEAR(found, wanted, 1e-11 * scale) << where;
}

// The same cells, numbers up to rounding; the first ones as texts.
void expect_same_rows(const std::string& found, const std::string& wanted, std::size_t texts, double scale) {
  const Rows a = rows_of(found), b = rows_of(wanted);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 1u);
  EXPECT_EQ(a[0], b[0]);
  for (std::size_t k = 1; k < a.size(); ++k) {
    ASSERT_EQ(a[k].size(), b[k].size());
    for (std::size_t c = 0; c < a[k].size(); ++c) {
      if (c < texts || a[k][c].empty() || b[k][c].empty()) {
        EXPECT_EQ(a[k][c], b[k][c]) << a[k][0];
      } else {
        expect_near(std::stod(a[k][c]), std::stod(b[k][c]), scale, a[k][0] + ", " + a[0][c]);
      }
    }
  }
}

// The numbers of a NumPy file of format 1.0.
std::vector<double> numbers_of(const std::string& npy) {
  const auto byte = [&](std::size_t k) { return std::size_t{static_cast<unsigned char>(npy.at(k))}; };
  const std::size_t begin = 10 + byte(8) + 256 * byte(9);
  std::vector<double> numbers((npy.size() - begin) / sizeof(double));
  std::memcpy(numbers.data(), npy.data() + begin, numbers.size() * sizeof(double));
  return numbers;
}

void expect_same_light(const std::string& found, const std::string& wanted) {
  const std::vector<double> a = numbers_of(found), b = numbers_of(wanted);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_EQ(a.size(), 6u);
  for (std::size_t k = 0; k < a.size(); ++k) expect_near(a[k], b[k], b[k], "cell " + std::to_string(k));
}

TEST(Units, OfALampAnAreaIsInMetresAndItsLightInWatts) {
  const double kelvin = std::pow(25 / kSigma, 0.25);
  for (const Unit& unit : {kMetre, kUnits[0], kUnits[1], kUnits[2], kUnits[3], kUnits[4]}) {
    const Workplace place;
    place.write("lamp.json", lamp(unit));
    const Outcome solved = place.run("hottel solve lamp.json -o out");
    ASSERT_EQ(solved.code, 0) << solved.err;
    const auto radiosity = table(place.read("out/radiosity.csv"), 1).at("floor");
    EXPECT_EQ(radiosity[3], "1") << unit.name;
    EXPECT_NEAR(std::stod(radiosity[9]), 25, 1e-13) << unit.name;
    const auto temperature = table(place.read("out/temperature.csv"), 1).at("floor");
    EXPECT_NEAR(std::stod(temperature[3]), kelvin, 1e-11) << unit.name;
    EXPECT_LE(std::stod(temperature[4]), kelvin);
    EXPECT_GE(std::stod(temperature[5]), kelvin);
    const auto flux = table(place.read("out/flux.csv"), 2).at("light,light[0]");
    EXPECT_NEAR(std::stod(flux[4]), 100, 1e-11) << unit.name;
    const Json report = Json::parse(place.read("out/report.json"));
    EXPECT_NEAR(report["energy"]["emitted"], 100, 1e-11);
    EXPECT_EQ(report["unit"], unit.name);
  }
}

// Two black faces across from each other, a metre square and a metre apart: what arrives is F sigma T⁴ m².
TEST(Units, OfTwoSquaresTheFluxIsWithinItsBounds) {
  const double x = std::sqrt(2.0),
               factor = 2 / std::numbers::pi *
                        (std::log(2 / std::sqrt(3.0)) + 2 * x * std::atan(1 / x) - 2 * std::atan(1.0));
  const double watts = factor * kSigma * std::pow(400.0, 4);
  for (const Unit& unit : kUnits) {
    const Workplace place;
    const auto at = [&](long a, long b, long c) { return point({a, b, c}, unit); };
    place.write("squares.json",
                head(3, unit) +
                    R"("materials": {"hot": {"emissivity": 1, "temperature": 400}, "cold": {}}, "polygons": [
      {"name": "hot", "points": [)" +
                    at(0, 0, 0) + "," + at(10, 0, 0) + "," + at(10, 10, 0) + "," + at(0, 10, 0) +
                    R"(], "material": "hot"}, {"name": "cold", "points": [)" + at(0, 0, 10) + "," + at(0, 10, 10) +
                    "," + at(10, 10, 10) + "," + at(10, 0, 10) + R"(], "material": "cold"}]})");
    ASSERT_EQ(place.run("hottel solve squares.json -o out --no-picture").code, 0);
    const auto flux = table(place.read("out/flux.csv"), 2).at("face,cold");
    EXPECT_EQ(flux[3], "1");
    EXPECT_NEAR(std::stod(flux[4]), -watts, 1e-9 * watts) << unit.name;
    EXPECT_LE(std::stod(flux[5]), -watts + 1e-12 * watts);
    EXPECT_GE(std::stod(flux[6]), -watts - 1e-12 * watts);
    const Json pair = Json::parse(place.run("hottel visibility squares.json --from hot --to cold --json").out);
    EXPECT_NEAR(pair["exchange"]["value"], factor, 1e-9);
    EXPECT_LE(pair["exchange"]["lower"], factor + 1e-14);
    EXPECT_GE(pair["exchange"]["upper"], factor - 1e-14);
    EXPECT_EQ(pair["area_from"]["value"], 1);
  }
}

TEST(Units, OneSceneInAnyUnitHasTheSameResults) {
  for (const bool is_plane : {true, false}) {
    const auto scene = is_plane ? room_2 : room_3;
    const Workplace place;
    place.write("m.json", scene(kMetre));
    const std::string lists = "--quiet --per element", exchange = "--matrix exchange " + lists;
    const std::string factors = place.run("hottel factors m.json " + lists).out,
                      areas = place.run("hottel factors m.json --areas " + lists).out,
                      measures = place.run("hottel factors m.json " + exchange).out;
    ASSERT_EQ(place.run("hottel solve m.json -o m --no-picture").code, 0);
    for (const Unit& unit : kUnits) {
      SCOPED_TRACE(unit.name);
      const std::string file = std::string(unit.name) + ".json", folder = std::string(unit.name) + "/";
      place.write(file, scene(unit));
      EXPECT_EQ(place.run("hottel factors " + file + " " + lists).out, factors);
      EXPECT_EQ(place.run("hottel factors " + file + " --areas " + lists).out, areas);
      const std::string found = place.run("hottel factors " + file + " " + exchange).out;
      if (is_plane) {
        EXPECT_EQ(found, measures);  // correctly rounded
      } else {
        expect_same_rows(found, measures, 1, 12);
      }
      const Outcome solved = place.run("hottel solve " + file + " --no-picture -o " + unit.name);
      ASSERT_EQ(solved.code, 0) << solved.err;
      expect_same_rows(place.read(folder + "radiosity.csv"), place.read("m/radiosity.csv"), 3, 2000);
      expect_same_rows(place.read(folder + "temperature.csv"), place.read("m/temperature.csv"), 3, 500);
      expect_same_rows(place.read(folder + "flux.csv"), place.read("m/flux.csv"), 3, 20000);
      expect_same_light(place.read(folder + "illumination.npy"), place.read("m/illumination.npy"));
    }
  }
}

TEST(Units, LampsShineOnPointsAndByTestsAsInMetres) {
  for (const bool is_plane : {true, false}) {
    const auto scene = is_plane ? room_2 : room_3;
    const Workplace place;
    const std::string head = is_plane ? "x,y,nx,ny\\n" : "x,y,z,nx,ny,nz\\n";
    const std::string normal = is_plane ? "0,1" : "0,0,1", ask = " | hottel visibility ";
    place.write("m.json", scene(kMetre));
    place.write("mm.json", scene(kUnits[0]));
    const std::string at_metres = is_plane ? "2.9,0.7," : "2.9,1.3,0.7,",
                      at = is_plane ? "2900,700," : "2900,1300,700,";
    const Outcome wanted = place.run("printf '" + head + at_metres + normal + "\\n'" + ask + "m.json --points -"),
                  found = place.run("printf '" + head + at + normal + "\\n'" + ask + "mm.json --points -");
    ASSERT_EQ(wanted.code, 0) << wanted.err;
    ASSERT_EQ(found.code, 0) << found.err;
    const Rows a = rows_of(found.out), b = rows_of(wanted.out);
    ASSERT_EQ(a.size(), 2u);
    ASSERT_EQ(a[1].size(), b[1].size());
    for (std::size_t c = is_plane ? 4 : 6; c < a[1].size(); ++c)
      expect_near(std::stod(a[1][c]), std::stod(b[1][c]), 1000, a[0][c]);
    for (const char* test : {"centroid", "vertices"}) {
      for (const char* name : {"m", "mm"})
        ASSERT_EQ(place
                      .run(std::string("hottel solve ") + name + ".json --no-picture --no-illumination --lights " +
                           test + " -o " + name)
                      .code,
                  0);
      expect_same_rows(place.read("mm/radiosity.csv"), place.read("m/radiosity.csv"), 3, 2000);
    }
  }
}

TEST(Units, ClosedFormsStayAsTypedAndDecimalsAreInMetres) {
  const Workplace place;
  place.write("strip.json", R"({"hottel": 1, "dimension": 2, "unit": "mm", "materials": {"black": {}}, "edges": [
    {"name": "a", "points": [[0, 1], [1, 2]], "material": "black"},
    {"name": "b", "points": [[1, 0], [0, 0]], "material": "black"}]})");
  const Outcome pair = place.run("hottel visibility strip.json --from a --to b");
  ASSERT_EQ(pair.code, 0) << pair.err;
  EXPECT_THAT(pair.out, HasSubstr(" m = 1*sqrt(2) in mm"));
  const Json json = Json::parse(place.run("hottel visibility strip.json --from a --to b --json").out);
  EXPECT_EQ(json["area_from"]["value"], 0.001414213562373095);
  EXPECT_EQ(json["area_from"]["exact"], "1*sqrt(2)");
  EXPECT_EQ(json["area_to"]["value"], 0.001);
  EXPECT_THAT(place.run("hottel factors strip.json --exact-form --quiet").out, HasSubstr("1*sqrt(2)"));
}

TEST(Units, WhatIsKeptOfOneUnitIsNotTakenForAnother) {
  for (const bool is_plane : {true, false}) {
    const Workplace place;
    std::string scene = (is_plane ? room_2 : room_3)(kMetre);
    place.write("room.json", scene);
    const std::string ask = "hottel factors room.json --quiet --matrix exchange";
    ASSERT_EQ(place.run(ask + " --store kept.db").code, 0);
    scene.replace(scene.find("\"m\""), 3, "\"mm\"");
    place.write("room.json", scene);
    const Outcome alone = place.run(ask), kept = place.run(ask + " --store kept.db");
    EXPECT_EQ(kept.out, alone.out);
    EXPECT_EQ(place.run(ask + " --store kept.db").out, alone.out);
  }
}

TEST(Units, OfAnUnknownNameNothingIsToldInWatts) {
  for (const bool is_plane : {true, false}) {
    const Workplace place;
    std::string scene = (is_plane ? room_2 : room_3)({"furlong", 1, 1});
    place.write("lit.json", scene);
    const Outcome refused = place.run("hottel solve lit.json -o out");
    EXPECT_EQ(refused.code, 1);
    EXPECT_THAT(refused.err, HasSubstr("lit.json: light 'light[0]'"));
    EXPECT_THAT(refused.err, HasSubstr("'furlong' is none of m, mm, cm, km, in or ft"));
    EXPECT_EQ(place.run("hottel factors lit.json --quiet").code, 0);
    const Outcome checked = place.run("hottel check lit.json --json");
    EXPECT_EQ(checked.code, 1);
    EXPECT_THAT(checked.out, HasSubstr("unknown-unit"));

    for (const char* power : {"\"power\": 300", "\"power\": 200"})
      scene.replace(scene.find(power), std::strlen(power), "\"power\": 0");
    place.write("sunny.json", scene);
    const Outcome solved = place.run("hottel solve sunny.json -o out --no-picture");
    ASSERT_EQ(solved.code, 0) << solved.err;
    const std::string note = is_plane ? "areas are lengths in furlong" : "areas are in furlong²";
    const auto first = solved.err.find(note);
    ASSERT_NE(first, std::string::npos) << solved.err;
    EXPECT_EQ(solved.err.find(note, first + 1), std::string::npos);
    EXPECT_THAT(solved.err, Not(HasSubstr("energy")));
    EXPECT_THAT(solved.err, Not(HasSubstr("net flux")));
    const std::vector<std::string> fluxes = lines_of(place.read("out/flux.csv"));
    EXPECT_EQ(fluxes[0], "per,name,channel,area,net,lower,upper");
    for (std::size_t k = 1; k < fluxes.size(); ++k) EXPECT_TRUE(fluxes[k].ends_with(",,,")) << fluxes[k];
    EXPECT_EQ(table(place.read("out/flux.csv"), 2).at("face,floor")[3], is_plane ? "4" : "12");
    const Json report = Json::parse(place.read("out/report.json"));
    EXPECT_TRUE(report["energy"]["emitted"].is_null());
    EXPECT_THAT(report["notes"].dump(), HasSubstr(note));
    if (!is_plane) {
      EXPECT_THAT(place.read("out/radiosity.vtu"), Not(HasSubstr("net_flux")));
    }
    place.write("m.json", [&] {
      std::string metres = scene;
      return metres.replace(metres.find("furlong"), 7, "m");
    }());
    ASSERT_EQ(place.run("hottel solve m.json -o m --no-picture").code, 0);
    EXPECT_EQ(place.read("out/radiosity.csv"), place.read("m/radiosity.csv"));
  }
}

TEST(Units, OfNoNameAreMetres) {
  for (const bool is_plane : {true, false}) {
    const Workplace place;
    std::string scene = (is_plane ? room_2 : room_3)(kMetre);
    place.write("m.json", scene);
    const std::string says = R"("unit": "m", )";
    place.write("none.json", scene.erase(scene.find(says), says.size()));
    for (const char* name : {"m", "none"})
      ASSERT_EQ(place.run(std::string("hottel solve ") + name + ".json --no-picture -o " + name).code, 0);
    for (const char* file : {"radiosity.csv", "flux.csv", "temperature.csv", "illumination.npy"})
      EXPECT_EQ(place.read(std::string("m/") + file), place.read(std::string("none/") + file)) << file;
  }
}

}  // namespace
}  // namespace hottel
