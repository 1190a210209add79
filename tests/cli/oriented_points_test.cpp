// hottel visibility --points of points with normals, as a stranger runs it: against closed forms and other commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::oriented_points_test {
namespace {

using std::numbers::pi;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

constexpr double kSigma = 5.670374419e-8;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line + ",");
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

// What is told of each point: the last columns.
std::vector<std::vector<std::string>> told(const Workplace& place, const std::string& scene, const std::string& points,
                                           std::size_t columns = 3) {
  place.write("points.csv", points);
  const Outcome outcome = place.run("hottel visibility " + scene + " --points points.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::vector<std::string>> result;
  const auto lines = lines_of(outcome.out);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    auto fields = fields_of(lines[k]);
    fields.erase(fields.begin(), fields.end() - static_cast<std::ptrdiff_t>(columns));
    result.push_back(fields);
  }
  return result;
}

// A street of width 1 between black walls of height h, under a sky that sends 100 W/m.
std::string canyon(const std::string& h) {
  return R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "sky": {"emission": 100}, "edges": [
    {"name": "road", "points": [[1, 0], [0, 0]], "material": "m"},
    {"name": "west", "points": [[0, 0], [0, )" +
         h + R"(]], "material": "m"}, {"name": "east", "points": [[1, )" + h + R"(], [1, 0]], "material": "m"}]})";
}

TEST(OrientedPoints, TheMiddleOfARoadSeesTheSkyBetweenTheEaves) {
  const Workplace place;
  for (const double h : {0.25, 1.0, 3.0}) {
    std::ostringstream text;
    text << h;
    place.write("canyon.json", canyon(text.str()));
    const auto rows = told(place, "canyon.json", "x,y,nx,ny\n0.5,0,0,1\n0.5,0,0,7\n0.5,0.1,0,-1\n");
    const double expected = std::cos(std::atan(2 * h));
    EXPECT_NEAR(number(rows[0][1]), expected, 1e-15) << h;
    EXPECT_NEAR(number(rows[0][0]), 100 * expected, 1e-13) << h;
    EXPECT_EQ(rows[1], rows[0]);  // of any length
    EXPECT_EQ(number(rows[2][1]), 0);
    EXPECT_EQ(number(rows[2][0]), 0);
  }
}

// A black square of 1 that emits, over the corner of which the point lies at distance 1 / s.
double under_a_corner(double a, double b) {
  const double u = std::sqrt(1 + a * a), v = std::sqrt(1 + b * b);
  return (a / u * std::atan(b / u) + b / v * std::atan(a / v)) / (2 * pi);
}

TEST(OrientedPoints, ARectangleOverAPointGivesTheFactorOfItsCorner) {
  const Workplace place;
  place.write("plate.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"emission": 10}}, "polygons": [
    {"name": "plate", "points": [[0,0,0],[0,3,0],[2,3,0],[2,0,0]], "material": "m", "elements": 3}]})");
  const auto rows =
      told(place, "plate.json", "x,y,z,nx,ny,nz\n0,0,-0.5,0,0,1\n0,0,-2,0,0,3\n1,1,-1,0,0,1\n0,0,-1,0,0,-1\n");
  for (const auto& [k, factor] : {std::pair(0, under_a_corner(4, 6)),
                                  {1, under_a_corner(1, 1.5)},
                                  {2, 2 * (under_a_corner(1, 1) + under_a_corner(1, 2))},
                                  {3, 0.0}}) {
    const auto& row = rows.at(static_cast<std::size_t>(k));
    EXPECT_NEAR(number(row[0]), 10 * factor, 1e-14) << k;
    EXPECT_NEAR(number(row[1]), 1 - factor, 1e-15) << k;
  }
}

// Everywhere in a room of one temperature the irradiance is that of a black body of it, and so is the mean radiant one.
TEST(OrientedPoints, ARoomOfOneTemperatureIsThatTemperature) {
  const Workplace place;
  place.write("flat.json", R"({"hottel": 1, "dimension": 2, "materials": {"w": {"emissivity": 0.7, "temperature": 300}},
    "polylines": [{"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "w", "elements": 3},
                  {"name": "box", "points": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true, "material": "w"}]})");
  ASSERT_EQ(place.run("hottel generate room-boxes --n 3 --seed 4 -o boxes.json").code, 0);
  std::mt19937_64 random(5);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::ostringstream flat;
  flat << "x,y,nx,ny\n3,1/7,1e-300,2e-300\n2,1.5,1,0\n";
  for (int k = 0; k < 50; ++k)
    flat << draw(0, 4) << "," << draw(0, 1) << "," << draw(-1, 1) << "," << draw(-1, 1) << "\n";
  const double black = kSigma * 300 * 300 * 300 * 300;
  for (const auto& row : told(place, "flat.json", flat.str())) {
    EXPECT_NEAR(number(row[0]), black, 1e-12 * black);
    EXPECT_NEAR(number(row[1]), 0, 1e-15);
    EXPECT_NEAR(number(row[2]), 300, 1e-11);
  }
}

// A lamp over a point, and a sun, seen by areas that look at them, aslant and away.
TEST(OrientedPoints, LightsArriveByTheCosine) {
  const Workplace place;
  for (const int dimension : {2, 3}) {
    const bool is_flat = dimension == 2;
    const std::string
        z = is_flat ? "" : ", 0",
        face = is_flat ? R"("edges": [{"name": "far", "points": [[50, 0], [51, 0]], "material": "m"}])"
                       : R"("polygons": [{"name": "far", "points": [[50,0,0],[51,0,0],[50,1,0]], "material": "m"}])";
    const std::string head = R"({"hottel": 1, "dimension": )" + std::to_string(dimension) +
                             R"(, "materials": {"m": {}}, )" + face + R"(, "lights": [)";
    place.write("lamp.json", head + R"({"type": "point", "name": "l", "position": [0, 2)" + z + R"(], "power": 12}]})");
    place.write("sun.json",
                head + R"({"type": "sun", "name": "s", "direction": [0, -3)" + z + R"(], "irradiance": 800}]})");
    const std::string points = is_flat ? "x,y,nx,ny\n0,0,0,1\n0,0,1,1\n0,0,0,-1\n"
                                       : "x,y,z,nx,ny,nz\n0,0,0,0,1,0\n0,0,0,1,1,0\n0,0,0,0,-1,0\n";
    const double straight = is_flat ? 12 / (2 * pi) / 2 : 12 / (4 * pi) / 4;
    const auto lamp = told(place, "lamp.json", points), sun = told(place, "sun.json", points);
    for (const auto& [k, cosine] : {std::pair(0, 1.0), {1, std::sqrt(0.5)}, {2, 0.0}}) {
      EXPECT_NEAR(number(lamp[static_cast<std::size_t>(k)][0]), straight * cosine, 1e-14) << dimension;
      EXPECT_NEAR(number(sun[static_cast<std::size_t>(k)][0]), 800 * cosine, 1e-12) << dimension;
    }
  }
}

// The mean radiant temperature is that of the mean irradiance which other commands write.
TEST(OrientedPoints, TheMeanIrradianceIsThatOfPointsAndGrids) {
  const Workplace place;
  place.write("flat.json", R"({"hottel": 1, "dimension": 2, "materials": {"w": {"emissivity": 0.9, "temperature": 290},
    "r": {"emissivity": 0.8, "temperature": 310}}, "sky": {"temperature": 260}, "edges": [
    {"name": "road", "points": [[9, 0], [0, 0]], "material": "r"},
    {"name": "west", "points": [[0, 0], [0, 7]], "material": "w"}]})");
  const auto flat = told(place, "flat.json", "x,y,nx,ny\n6,1.5,0,1\n2,1.1,1,0\n");
  const auto polygons = lines_of(
      place.run("printf '6,1.5\\n2,1.1\\n' | hottel visibility flat.json --points - --range 1 --irradiance").out);
  std::vector<double> means;
  for (const std::string& line : polygons)
    if (const auto fields = fields_of(line); fields[1] == "0") means.push_back(number(fields[5]));
  ASSERT_EQ(means.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_DOUBLE_EQ(number(flat[k][2]), std::pow(means[k] / kSigma, 0.25));

  place.write("space.json", R"({"hottel": 1, "dimension": 3, "materials": {"w": {"emissivity": 0.9, "temperature": 290},
    "r": {"emissivity": 0.8, "temperature": 310}}, "sky": {"temperature": 260},
    "grid": {"origin": [1, 1, 1], "u": [2, 0, 0], "v": [0, 2, 0], "cells": [1, 1]}, "polygons": [
    {"name": "floor", "points": [[0,0,0],[5,0,0],[5,5,0],[0,5,0]], "material": "w", "elements": 2},
    {"name": "wall", "points": [[0,0,0],[0,5,0],[0,5,3],[0,0,3]], "material": "r"}]})");
  ASSERT_EQ(place.run("hottel solve space.json -o out --no-picture --quiet").code, 0);
  const std::string array = place.read("out/illumination.npy");
  double mean = 0;
  std::memcpy(&mean, array.data() + array.size() - sizeof mean, sizeof mean);
  const auto rows = told(place, "space.json", "x,y,z,nx,ny,nz\n2,2,1,0,0,1\n");
  EXPECT_DOUBLE_EQ(number(rows[0][2]), std::pow(mean / kSigma, 0.25));
}

TEST(OrientedPoints, ChannelsAndBandsAreColumns) {
  const Workplace place;
  const std::string scenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
  const auto head = [&](const std::string& scene) {
    return lines_of(
               place.run("printf 'x,y,nx,ny\\n6,1,0,1\\n' | hottel visibility " + scenes + scene + " --points -").out)
        .at(0);
  };
  EXPECT_EQ(head("heat/street_canyon.json"), "point,x,y,nx,ny,irradiance,sky_view_factor,mean_radiant_temperature");
  EXPECT_EQ(head("heat/street_by_day.json"),
            "point,x,y,nx,ny,irradiance_solar,irradiance_thermal,sky_view_factor,mean_radiant_temperature");
  EXPECT_EQ(head("showcase/apartment.json"),
            "point,x,y,nx,ny,irradiance_r,irradiance_g,irradiance_b,sky_view_factor,mean_radiant_temperature");
}

TEST(OrientedPoints, PointsInSolidsHaveNoLight) {
  const Workplace place;
  place.write("flat.json", R"({"hottel": 1, "dimension": 2, "materials": {"w": {"emissivity": 0.7, "temperature": 300}},
    "polylines": [{"name": "box", "points": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true, "material": "w"}]})");
  place.write("points.csv", "x,y,nx,ny\n0,0,0,1\n1.5,1.5,0,1\n");
  const Outcome outcome = place.run("hottel visibility flat.json --points points.csv");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(lines_of(outcome.out).at(2), "1,1.5,1.5,0,1,,,");
  EXPECT_THAT(outcome.err, HasSubstr("have no light: 1, the first is point 1"));
}

// A point on the border of a box does not see through the box. A point in the wall between two boxes has no light.
TEST(OrientedPoints, NothingIsSeenThroughSolids) {
  const auto box = [](const std::string& name, int x, int height) {
    const auto at = [&](int a, int b, int c) {
      return "[" + std::to_string(x + a) + "," + std::to_string(b) + "," + std::to_string(c * height) + "]";
    };
    const std::vector<std::array<std::array<int, 3>, 4>> sides{
        {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
        {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}, {{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}}},
        {{{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}};
    std::string text;
    for (const auto& side : sides) {
      text += R"(, {"group": ")" + name + R"(", "material": "cold", "points": [)";
      for (std::size_t k = 0; k < 4; ++k) text += (k == 0 ? "" : ",") + at(side[k][0], side[k][1], side[k][2]);
      text += "]}";
    }
    return text;
  };
  const std::string floor = R"({"hottel": 1, "dimension": 3, "materials": {"hot": {"emission": 100}, "cold": {}},
    "polygons": [{"name": "floor", "points": [[-5,-5,0],[5,-5,0],[5,5,0],[-5,5,0]], "material": "hot"})";
  const Workplace place;
  place.write("box.json", floor + box("box", 0, 1) + "]}");
  for (const auto& columns : told(place, "box.json", "x,y,z,nx,ny,nz\n0.5,0.5,1,0,0,1\n0.5,0.5,1,0,0,-1\n"))
    EXPECT_THAT(columns, testing::ElementsAre("0", columns[1], "0"));
  // On an edge a quarter of the sphere is in the box: the floor beside it is seen, and the mean is of what is seen.
  const auto edge = told(place, "box.json", "x,y,z,nx,ny,nz\n0.5,0,1,0,-1,0\n0.5,0,2,0,-1,0\n");
  EXPECT_GT(number(edge[0][0]), 30);
  place.write("two.json", floor + box("a", 0, 1) + box("b", 1, 2) + "]}");
  const auto between = told(place, "two.json", "x,y,z,nx,ny,nz\n1,0.5,0.5,1,0,0\n1,0.5,1.5,-1,0,0\n");
  EXPECT_THAT(between[0], testing::ElementsAre("", "", ""));
  EXPECT_NE(between[1][0], "");
}

TEST(OrientedPoints, NormalsBeyondDoublesAreWrittenByTheirDirection) {
  const Workplace place;
  place.write("canyon.json", canyon("1"));
  place.write("points.csv", "x,y,nx,ny\n0.5,0.5,1e4000,1e4000\n0.5,0.5,0,-1e-4000\n");
  const auto lines = lines_of(place.run("hottel visibility canyon.json --points points.csv").out);
  EXPECT_THAT(lines.at(1), testing::StartsWith("0,0.5,0.5,1,1,"));
  EXPECT_THAT(lines.at(2), testing::StartsWith("1,0.5,0.5,0,-1,"));
}

TEST(OrientedPoints, WhatMakesNoSenseIsRefused) {
  const Workplace place;
  place.write("flat.json", canyon("1"));
  const auto refused = [&](const std::string& points, const std::string& options, int code) {
    place.write("points.csv", points);
    const Outcome outcome = place.run("hottel visibility flat.json --points points.csv " + options);
    EXPECT_EQ(outcome.code, code) << points << options;
    return outcome.err;
  };
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0,0\n", "", 3), HasSubstr("points.csv:2: the normal of a point is zero"));
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0\n", "", 3),
              HasSubstr("points.csv:2: a point and its normal are 4 numbers, not 3"));
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0,up\n", "", 3), HasSubstr("points.csv:2: 'up' is no number"));
  EXPECT_THAT(refused("x,y,z,nx,ny,nz\n0,1,0,0,0,1\n", "", 3),
              HasSubstr("is x,y,nx,ny in the plane, not x,y,z,nx,ny,nz"));
  EXPECT_THAT(refused("x,y,nx,ny\n", "", 3), HasSubstr("there is no point in it"));
  EXPECT_THAT(refused("0,1,0,1\n", "", 3),
              HasSubstr("points.csv:1: a point has two coordinates x,y, in space three x,y,z, not 4"));
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0,1\n", "--range 2", 2), HasSubstr("--range is for polygons"));
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0,1\n", "--side front", 2), HasSubstr("--side is for polygons"));
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0,1\n", "--exact", 2), HasSubstr("--exact is for polygons"));
  EXPECT_THAT(refused("x,y,nx,ny\n0,1,0,1\n", "-o out.wkt", 2), HasSubstr("is written as .csv, not 'out.wkt'"));
}

// ---- how large polygons are

TEST(OrientedPoints, PolygonsHaveTheirAreaAndPerimeter) {
  const Workplace place;
  place.write("room.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}}, "polylines": [
    {"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "m"},
    {"name": "box", "points": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true, "material": "m"}]})");
  const auto last = [&](const std::string& options) {
    const auto lines = lines_of(place.run("hottel visibility room.json --points - " + options).out);
    const auto fields = fields_of(lines.at(1));
    return fields.at(fields.size() - 2) + " " + fields.back();
  };
  // From (3, 3/2) the box and what it hides are a trapezium: 12 - 4.
  EXPECT_EQ(last("<<< 3,3/2").substr(0, 2), "8 ");
  EXPECT_EQ(last("--exact <<< 3,3/2").substr(0, 2), "8 ");
  EXPECT_EQ(last("<<< 3/2,3/2"), " ");  // in the box
  EXPECT_EQ(last("<<< 9,9"), " ");      // unbounded
  std::istringstream disc(last("--range 1/2 <<< 3,3/2"));
  double area = 0, perimeter = 0;
  disc >> area >> perimeter;
  EXPECT_DOUBLE_EQ(area, pi / 4);
  EXPECT_DOUBLE_EQ(perimeter, pi);
  // Within 9/10 of a point a half above the floor: a disc without a segment.
  std::istringstream cut(last("--range 9/10 <<< 3,0.5"));
  cut >> area >> perimeter;
  const double half = std::acos(0.5 / 0.9), chord = 2 * 0.9 * std::sin(half);
  EXPECT_NEAR(area, 0.81 * (pi - half) + 0.5 * chord / 2, 1e-14);
  EXPECT_NEAR(perimeter, 2 * 0.9 * (pi - half) + chord, 1e-14);
  const std::string json = place.run("hottel visibility room.json --points - -o a.geojson <<< 9,9; cat a.geojson").out;
  EXPECT_THAT(json, AllOf(HasSubstr("\"area\":null"), HasSubstr("\"perimeter\":null")));
}

}  // namespace
}  // namespace hottel::oriented_points_test
