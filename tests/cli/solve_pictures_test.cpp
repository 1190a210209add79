// hottel solve --show, --render, --shading: what the pictures show, in space and in the plane, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::solve_pictures_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string scene_file(const std::string& name) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/" + name; }

// A column of radiosity.csv.
std::vector<double> column(const std::string& csv, std::size_t index, const std::string& channel = "") {
  std::vector<double> result;
  for (const std::string& line : lines_of(csv)) {
    std::vector<std::string> cell;
    std::istringstream stream(line);
    for (std::string text; std::getline(stream, text, ',');) cell.push_back(text);
    if (cell[0] != "face" && (channel.empty() || cell[2] == channel)) result.push_back(std::stod(cell[index]));
  }
  return result;
}

void expect_range(const nlohmann::json& report, const std::vector<double>& values) {
  EXPECT_EQ(report["picture"]["lower"].get<double>(), *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(report["picture"]["upper"].get<double>(), *std::max_element(values.begin(), values.end()));
}

constexpr std::size_t kRadiosity = 6, kIrradiance = 9, kNet = 10;

TEST(SolvePictures, ShowTheDoublesOfTheTable) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  place.write("square.json", contents(scene_file("analytic/square_radiosity.json")));
  for (const auto& [scene, picture, unit] : {std::tuple{"cube.json", "render.png", "W/m²"},
                                             std::tuple{"square.json --no-illumination", "illumination.png", "W/m²"}})
    for (const auto& [word, index] :
         {std::pair{"radiosity", kRadiosity}, std::pair{"irradiance", kIrradiance}, std::pair{"net", kNet}}) {
      const std::string line = std::string("hottel solve ") + scene + " -o out --elements 2 --show " + word;
      const Outcome outcome = place.run(line);
      ASSERT_EQ(outcome.code, 0) << line << outcome.err;
      const auto report = nlohmann::json::parse(place.read("out/report.json"));
      expect_range(report, column(place.read("out/radiosity.csv"), index));
      EXPECT_EQ(report["picture"]["unit"], unit);
      EXPECT_THAT(place.read(std::string("out/") + picture), StartsWith("\x89PNG"));
    }
}

TEST(SolvePictures, OfOneChannelAreItsDoubles) {
  const Workplace place;
  place.write("boxes.json", contents(scene_file("space/two_boxes.json")));
  ASSERT_EQ(place.run("hottel solve boxes.json -o out --tolerance 1e-5 --show irradiance --channel b").code, 0);
  const auto report = nlohmann::json::parse(place.read("out/report.json"));
  expect_range(report, column(place.read("out/radiosity.csv"), kIrradiance, "b"));
  EXPECT_EQ(report["picture"]["quantity"], "irradiance, b");
}

// The numbers of a .npy of doubles.
std::vector<double> doubles_of(const std::string& npy) {
  const std::size_t begin = npy.find('\n') + 1;
  std::vector<double> values((npy.size() - begin) / sizeof(double));
  std::memcpy(values.data(), npy.data() + begin, values.size() * sizeof(double));
  return values;
}

// The centres of cells are points with the normal of the grid.
TEST(SolvePictures, GridsInSpaceShowWhatPointsGet) {
  const Workplace place;
  place.write("floor.json", R"({"hottel": 1, "dimension": 3, "sky": {"temperature": 260}, "materials": {
    "w": {"emissivity": 0.9, "temperature": 290}, "r": {"emissivity": 0.8, "temperature": 310}},
    "grid": {"origin": [0, 0, 1], "u": [4, 0, 0], "v": [0, 4, 0], "cells": [2, 1]}, "polygons": [
    {"name": "floor", "points": [[0,0,0],[5,0,0],[5,5,0],[0,5,0]], "material": "w"},
    {"name": "wall", "points": [[0,0,0],[0,5,0],[0,5,3],[0,0,3]], "material": "r"}]})");
  place.write("points.csv", "x,y,z,nx,ny,nz\n1,2,1,0,0,1\n3,2,1,0,0,1\n");
  const auto lines = lines_of(place.run("hottel visibility floor.json --points points.csv").out);
  for (const auto& [word, from_end, unit] :
       {std::tuple{"irradiance", 3, "W/m²"}, std::tuple{"sky", 2, "1"}, std::tuple{"temperature", 1, "K"}}) {
    const Outcome outcome = place.run(std::string("hottel solve floor.json -o out --show ") + word);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto about = nlohmann::json::parse(place.read("out/shown.npy.json"));
    EXPECT_EQ(about["unit"], unit);
    EXPECT_EQ(about["shape"], nlohmann::json({1, 2}));
    const std::vector<double> shown = doubles_of(place.read("out/shown.npy"));
    ASSERT_EQ(shown.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<std::string> cells;
      std::istringstream stream(lines.at(k + 1));
      for (std::string text; std::getline(stream, text, ',');) cells.push_back(text);
      EXPECT_EQ(shown[k], std::stod(cells[cells.size() - static_cast<std::size_t>(from_end)])) << word;
    }
    EXPECT_THAT(place.read("out/illumination.png"), StartsWith("\x89PNG"));
  }
}

// In the plane cells have the mean of all directions, and one scale with the faces.
TEST(SolvePictures, GridsInThePlaneShareTheScaleOfTheFaces) {
  const Workplace place;
  place.write("road.json", R"({"hottel": 1, "dimension": 2, "sky": {"temperature": 200}, "materials": {
    "r": {"emissivity": 1, "temperature": 300}}, "grid": {"min": [-1, 0], "max": [1, 2], "cells": [1, 1]}, "edges": [
    {"name": "road", "points": [[1, 0], [-1, 0]], "material": "r"}]})");
  ASSERT_EQ(place.run("hottel solve road.json -o out --show temperature").code, 0);
  // Half a turn less two eighths of the way to the ends: the road takes a quarter of what is seen from its middle.
  const double expected = std::pow(0.25 * std::pow(300, 4) + 0.75 * std::pow(200, 4), 0.25);
  const std::vector<double> shown = doubles_of(place.read("out/shown.npy"));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_NEAR(shown[0], expected, 1e-10);
  const auto report = nlohmann::json::parse(place.read("out/report.json"));
  EXPECT_EQ(report["picture"]["lower"], shown[0]);
  EXPECT_EQ(report["picture"]["upper"], 300);
  const std::string with_cells = place.read("out/illumination.png");
  ASSERT_EQ(place.run("hottel solve road.json -o out --show sky").code, 0);
  EXPECT_NEAR(doubles_of(place.read("out/shown.npy"))[0], 0.75, 1e-15);
  ASSERT_EQ(place.run("hottel solve road.json -o faces --show temperature --no-illumination").code, 0);
  EXPECT_EQ(place.run("ls faces").out, "flux.csv\nillumination.png\nradiosity.csv\nreport.json\ntemperature.csv\n");
  EXPECT_NE(place.read("faces/illumination.png"), with_cells);
}

// A hot plate and one that nobody heats, before a sky.
constexpr const char* kPlates = R"({"hottel": 1, "dimension": 3, "sky": {"emission": 3}, "materials": {
  "hot": {"emissivity": 0.5, "temperature": 400}, "warm": {"emissivity": 0.9, "temperature": 293.15}}, "polygons": [
  {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "hot", "back": "warm"},
  {"name": "high", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "warm"}]})";

TEST(SolvePictures, ShowTemperaturesAndViewFactors) {
  const Workplace place;
  place.write("plates.json", kPlates);
  const auto picture = [&](const std::string& word) {
    const Outcome outcome = place.run("hottel solve plates.json -o out --show " + word);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(place.read("out/report.json"))["picture"];
  };
  const auto warm = picture("temperature");
  EXPECT_EQ(warm["lower"], 293.15);
  EXPECT_EQ(warm["upper"], 400);
  EXPECT_EQ(warm["unit"], "K");
  const auto sky = picture("sky");
  EXPECT_EQ(sky["upper"], 1);
  EXPECT_EQ(sky["quantity"], "view factor to the sky");
  // Opposite squares at the distance of their side: F = 0.19982489569838730.
  EXPECT_NEAR(sky["lower"].get<double>(), 1 - 0.19982489569838730, 1e-12);
  EXPECT_NEAR(picture("factor:high")["upper"].get<double>(), 0.19982489569838730, 1e-12);
  EXPECT_EQ(picture("factor:high:back")["upper"], 0);
}

TEST(SolvePictures, WhatIsNotThereIsRefused) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  place.write("square.json", contents(scene_file("analytic/square_radiosity.json")));
  for (const char* scene : {"cube.json", "square.json"})
    for (const auto& [options, message] :
         {std::pair{"--show heat", "nothing that can be shown is called 'heat'"},
          std::pair{"--show temperature", "no face of "}, std::pair{"--show factor:nobody", "is called 'nobody'"},
          std::pair{"--show net --tone linear", "--tone and --exposure need --show light"},
          std::pair{"--show sky --channel r", "--channel goes with --show radiosity, irradiance or net"},
          std::pair{"--channel r", "--channel goes with"}, std::pair{"--show net --channel r", "has one channel"},
          std::pair{"--render room.gif", "a picture is written as .png, .svg, .pdf, .exr or .npy"},
          std::pair{"--render x.svg --no-picture", "excludes"}}) {
      const Outcome outcome = place.run(std::string("hottel solve ") + scene + " -o out " + options);
      EXPECT_EQ(outcome.code, 2) << scene << ' ' << options << '\n' << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(message)) << scene << ' ' << options;
    }
  EXPECT_THAT(place.run("hottel solve cube.json --show factor:cieling -o out").err, HasSubstr("ceiling"));
  EXPECT_THAT(place.run("hottel solve square.json --shading smooth -o out").err, HasSubstr("for the values of --show"));
  EXPECT_THAT(place.run("hottel solve square.json --show net --size 50 -o out").err, HasSubstr("is 200 at least"));
  EXPECT_FALSE(std::filesystem::exists(place.path("out")));
}

TEST(SolvePictures, AreWrittenToAnotherFileToo) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  place.write("square.json", contents(scene_file("analytic/square_radiosity.json")));
  for (const char* scene : {"cube.json", "square.json --grid 8x8"})
    for (const char* show : {"light", "irradiance"}) {
      const auto line = [&](const std::string& file) {
        return std::string("hottel solve ") + scene + " -o out --show " + show + " --render " + file;
      };
      ASSERT_EQ(place.run(line("p.svg")).code, 0);
      EXPECT_THAT(place.read("p.svg"), StartsWith("<?xml"));
      ASSERT_EQ(place.run(line("p.pdf")).code, 0);
      EXPECT_THAT(place.read("p.pdf"), StartsWith("%PDF"));
      ASSERT_EQ(place.run(line("p.png")).code, 0);
      const std::string usual = scene[0] == 'c' ? "out/render.png" : "out/illumination.png";
      EXPECT_EQ(place.read("p.png"), place.read(usual));
    }
}

TEST(SolvePictures, AxesInSpaceTellHowFarTheSceneReaches) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  for (const char* show : {"light", "irradiance"}) {
    ASSERT_EQ(place.run(std::string("hottel solve cube.json -o out --axes --render p.svg --show ") + show).code, 0);
    EXPECT_THAT(place.read("p.svg"), HasSubstr("x 0 to 1 m"));
  }
  place.write("yard.json", R"({"hottel": 1, "dimension": 3, "sky": {"emission": 1}, "materials": {"m": {}},
    "grid": {"origin": [0, 0, 1], "u": [4, 0, 0], "v": [0, 4, 0], "cells": [2, 2]}, "polygons": [
    {"points": [[0,0,0],[5,0,0],[5,5,0]], "material": "m"}]})");
  for (const char* show : {"light", "irradiance"}) {
    const std::string line = std::string("hottel solve yard.json -o out --show ") + show;
    ASSERT_EQ(place.run(line).code, 0);
    const std::string plain = place.read("out/illumination.png");
    ASSERT_EQ(place.run(line + " --axes").code, 0);
    EXPECT_NE(place.read("out/illumination.png"), plain);
  }
}

TEST(SolvePictures, BarsAreCutWhereALampWouldFlattenThem) {
  const Workplace place;
  place.write("lamp.json", R"({"hottel": 1, "dimension": 3, "sky": {"emission": 1}, "materials": {
    "m": {"reflectivity": 0.5}, "lamp": {"emission": 1000}}, "polygons": [
    {"name": "floor", "points": [[0,0,0],[5,0,0],[5,5,0],[0,5,0]], "material": "m", "elements": 5},
    {"name": "lamp", "points": [[2,2,3],[2,3,3],[3,3,3],[3,2,3]], "material": "lamp"}]})");
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(place.run("hottel solve lamp.json -o out --tolerance 1e-4 --show radiosity " + options).code, 0);
    return nlohmann::json::parse(place.read("out/report.json"))["picture"];
  };
  const auto fitted = picture("");
  expect_range({{"picture", fitted}}, column(place.read("out/radiosity.csv"), kRadiosity));
  EXPECT_EQ(fitted["upper"], 1000);
  EXPECT_LT(fitted["bar_upper"], 100);
  EXPECT_EQ(fitted["bar_lower"], fitted["lower"]);
  const auto asked = picture("--bar 0:2000");
  EXPECT_EQ(asked["bar_upper"], 2000);
  EXPECT_EQ(asked["upper"], 1000);
}

TEST(SolvePictures, SmoothOnesBlendElements) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(place.run("hottel solve cube.json -o out --size 80 " + options).code, 0);
    return place.read("out/render.png");
  };
  EXPECT_NE(picture("--elements 3 --shading smooth"), picture("--elements 3"));
  EXPECT_EQ(picture("--elements 3 --shading flat"), picture("--elements 3"));
  EXPECT_EQ(picture("--shading smooth"), picture(""));  // one element a surface: nothing to blend
}

TEST(SolvePictures, ParentsStandForTheFinestElements) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(place.run("hottel solve cube.json -o out --size 80 " + options).code, 0);
    return place.read("out/render.png");
  };
  EXPECT_NE(picture("--levels 2 --shading parents"), picture("--levels 2 --shading smooth"));
  EXPECT_NE(picture("--levels 2 --shading parents"), picture("--levels 2"));
  // Elements that are given have no parents.
  EXPECT_EQ(picture("--elements 3 --shading parents"), picture("--elements 3 --shading smooth"));
}

TEST(SolvePictures, GatheredOnesHaveTheLightOfPoints) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(place.run("hottel solve cube.json -o out --size 60 " + options).code, 0);
    return place.read("out/render.png");
  };
  const std::string gathered = picture("--elements 3 --shading gathered --render light.npy");
  EXPECT_NE(gathered, picture("--elements 3 --shading smooth"));
  EXPECT_NE(picture("--show irradiance --shading gathered"), picture("--show irradiance"));
  const auto about = nlohmann::json::parse(place.read("light.npy.json"));
  EXPECT_EQ(about["shape"], (std::vector<int>{60, 60, 1}));
  EXPECT_EQ(place.read("light.npy").size(), 128u + 60 * 60 * sizeof(double));
}

// A texel is the light of its middle: that of the floor's is brighter than that of its corners.
TEST(SolvePictures, TexelsAreALightmap) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("space/cube.json")));
  ASSERT_EQ(place.run("hottel solve cube.json -o out --texels floor=3x3").code, 0);
  const std::string bytes = place.read("out/texels.npy");
  ASSERT_EQ(bytes.size(), 128u + 9 * sizeof(double));
  std::array<double, 9> light{};
  std::memcpy(light.data(), bytes.data() + 128, sizeof light);
  EXPECT_GT(light[4], light[0]);
  EXPECT_NEAR(light[0], light[8], 1e-9);
  EXPECT_EQ(place.read("out/texels.png").substr(1, 3), "PNG");
  EXPECT_EQ(nlohmann::json::parse(place.read("out/texels.npy.json"))["face"], "floor");
}

TEST(SolvePictures, ValuesRunAlongFacesInThePlane) {
  const Workplace place;
  place.write("square.json", contents(scene_file("analytic/square_radiosity.json")));
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(place.run("hottel solve square.json -o out --show net --grid 8x8 " + options).code, 0);
    return place.read("out/illumination.png");
  };
  EXPECT_NE(picture("--levels 3 --shading smooth"), picture("--levels 3"));
  EXPECT_NE(picture("--levels 3 --shading smooth"), picture("--levels 3 --shading parents"));
  EXPECT_EQ(picture("--levels 3 --shading flat"), picture("--levels 3"));
}

}  // namespace
}  // namespace hottel::solve_pictures_test
