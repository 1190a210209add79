// hottel compare, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace hottel::compare_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
const std::string kSquare = kScenes + "analytic/square_radiosity.json";

TEST(Compare, WritesTheFilesOfTheContract) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare + "' --methods exact,exact:normalised --repeat 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const auto csv = lines_of(place.read("square_radiosity-hottel/compare.csv"));
  ASSERT_EQ(csv.size(), 3u);
  EXPECT_EQ(csv[0], "method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error");
  EXPECT_THAT(csv[1], StartsWith("exact,exact,"));
  EXPECT_THAT(csv[2], StartsWith("exact:normalised,estimated,"));
  EXPECT_THAT(place.read("square_radiosity-hottel/compare.svg"), HasSubstr("<svg"));
  EXPECT_THAT(place.read("square_radiosity-hottel/compare.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(lines_of(place.read("square_radiosity-hottel/worst.csv")).at(0),
            "method,from,to,value,exact,error,visibility,distance,angle,reason");
  EXPECT_THAT(outcome.err, HasSubstr("exact:normalised"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("at an error of"))) << "no other method is timed";
}

TEST(Compare, WritesWhereItIsToldAndOneTableRowAMethodInTheOrderAskedFor) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel compare '" + kSquare + "' --methods exact:normalised,exact,exact -o a/b --repeat 1").code,
            0);
  const auto csv = lines_of(place.read("a/b/compare.csv"));
  ASSERT_EQ(csv.size(), 3u) << "a method that is named twice is run once";
  EXPECT_THAT(csv[1], StartsWith("exact:normalised,"));
  EXPECT_THAT(csv[2], StartsWith("exact,"));
}

TEST(Compare, RunsOneOfEachFamilyUnlessTold) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare + "' -o out --repeat 1 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  std::vector<std::string> methods;
  for (const auto& method : json["methods"]) methods.push_back(method["method"]);
  EXPECT_THAT(methods, ::testing::Contains("exact"));
  EXPECT_EQ(json["methods"][0]["max_error"], 0);
  EXPECT_EQ(json["methods"][0]["max_radiosity_error"], 0);
  EXPECT_GT(json["methods"][0]["seconds"]["median"], 0);
  EXPECT_EQ(json["methods"][0]["seconds"]["runs"], 1);
}

TEST(Compare, ListsAsManyOfTheWorstPairsAsAsked) {
  const Workplace place;
  const std::string line = "hottel compare '" + kSquare + "' --elements 5 --methods exact:normalised --repeat 1 -o out";
  for (const std::size_t count : {0u, 3u}) {
    ASSERT_EQ(place.run(line + " --worst " + std::to_string(count)).code, 0);
    const auto worst = lines_of(place.read("out/worst.csv"));
    ASSERT_EQ(worst.size(), 1 + count);
    for (std::size_t k = 1; k < worst.size(); ++k) EXPECT_THAT(worst[k], StartsWith("exact:normalised,"));
  }
}

TEST(Compare, DividesAsSolveDoes) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel compare '" + kSquare + "' --elements 3 --methods exact --repeat 1 -o out --json --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["methods"][0]["pairs"], 4 * 3 * 3 * 3);
}

TEST(Compare, LeavesOutWhatFollowsInASweepThatTakesTooLong) {
  const Workplace place;
  const std::string line = "hottel compare '" + kSquare + "' --methods gauss --sweep --repeat 1 -o out";
  ASSERT_EQ(place.run(line).code, 0);
  const std::size_t all = lines_of(place.read("out/compare.csv")).size();
  const Outcome outcome = place.run(line + " --at-most 1e-12");
  ASSERT_EQ(outcome.code, 0);
  EXPECT_GT(all, 3u);
  EXPECT_EQ(lines_of(place.read("out/compare.csv")).size(), 2u);
  EXPECT_THAT(outcome.err, HasSubstr("is left out"));
}

TEST(Compare, DrawsWhereAMethodIsWrong) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel compare '" + kSquare +
                     "' --methods exact:normalised --map exact:normalised --repeat 1 "
                     "-o out")
                .code,
            0);
  EXPECT_THAT(place.read("out/errors.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(place.run("hottel compare '" + kSquare + "' --methods exact --map exact:normalised -o out").code, 2);
}

// Fields of a line without quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line)
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  return fields;
}

TEST(Compare, TellsWhatDividingGives) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel compare '" + kSquare +
                "' --methods center,rays:64 --divide 1,2,4,8 --repeat 1 -o out --json > report.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(place.read("out/divide.csv"));
  ASSERT_EQ(lines.size(), 1u + 4 * 3);
  EXPECT_EQ(
      lines[0],
      "divide,elements,method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error,face_radiosity_error,"
      "face_radiosity_change,order");
  double before = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto exact = fields_of(lines.at(1 + 3 * k)), center = fields_of(lines.at(2 + 3 * k));
    EXPECT_EQ(exact[0], std::to_string(1 << k));
    EXPECT_EQ(exact[1], std::to_string(4 << k));
    EXPECT_EQ(exact[2], "exact");
    EXPECT_EQ(exact[5], "0");
    EXPECT_EQ(exact[8], "0");
    EXPECT_EQ(center[2], "center");
    EXPECT_EQ(center[9] == "", k == 3);
    EXPECT_EQ(exact[10] == "", k == 0);
    EXPECT_EQ(exact[11] == "", k < 2);
    if (k > 1) {
      EXPECT_NEAR(std::stod(exact[11]), 1.8, 0.3);
    }
    if (k == 3) {
      EXPECT_EQ(exact[9], "") << "the finest is what the others are held against";
    } else {
      EXPECT_LE(std::stod(exact[9]), before);
      before = std::stod(exact[9]);
    }
  }
  EXPECT_THAT(place.read("out/divide.svg"), HasSubstr(">exact factors: error of dividing</text>"));
  EXPECT_THAT(place.read("out/divide.png"), StartsWith("\x89PNG"));
  EXPECT_EQ(nlohmann::json::parse(place.read("report.json"))["results"].size(), 12u);
  EXPECT_THAT(outcome.err, HasSubstr("order"));

  // The continuous mean of the bottom, as 64, 128 and 256 elements extrapolate it.
  constexpr double kBottom = 1.148630192;
  const auto faces = lines_of(place.read("out/divide_faces.csv"));
  ASSERT_EQ(faces.size(), 1u + 3 * 4 * 4) << "methods, faces, divisions";
  EXPECT_EQ(faces[0], "method,face,channel,divide,mean,order,extrapolated,convergence");
  const auto coarse = fields_of(faces[3]), fine = fields_of(faces[4]);
  EXPECT_EQ(fine[0] + fine[1] + fine[2] + fine[3], "exactbottomall8");
  EXPECT_EQ(coarse[7], "");
  EXPECT_EQ(fine[7], "regular");
  EXPECT_LT(std::abs(std::stod(fine[6]) - kBottom), std::abs(std::stod(fine[4]) - kBottom) / 5)
      << "extrapolated it is nearer to the continuous one";
  const auto json = nlohmann::json::parse(place.read("report.json"))["faces"];
  ASSERT_EQ(json.size(), 12u);
  EXPECT_EQ(json[0]["divisions"], nlohmann::json({1, 2, 4, 8}));
  EXPECT_EQ(json[0]["means"][3].get<double>(), std::stod(fine[4]));
  EXPECT_EQ(json[0]["extrapolated"].get<double>(), std::stod(fine[6]));
  EXPECT_TRUE(json[0]["orders"][1].is_null());
  EXPECT_EQ(json[0]["convergence"], "regular");
  EXPECT_THAT(outcome.err, HasSubstr("mean radiosities of faces by exact factors:\n  bottom"));
}

// A screen whose shadow elements straddle now here, now there.
TEST(Compare, SaysWhereOrdersOfDividingAreIrregular) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kScenes +
                                    "showcase/apartment.json' --methods exact --divide 1,2,3,4 --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("orders are irregular for "));
  EXPECT_THAT(place.read("out/divide_faces.csv"), HasSubstr("irregular: changes of both signs"));
  EXPECT_THAT(place.read("out/divide_faces.csv"), HasSubstr(",irregular: orders from "));
  EXPECT_THAT(place.run("hottel compare '" + kSquare + "' --methods exact --divide 2,4 --repeat 1 -o out").err,
              HasSubstr("orders of convergence need three divisions"));
}

TEST(Compare, TellsTheOrdersOfDividingInSpace) {
  const Workplace place;
  const Outcome outcome =
      place.run("hottel compare '" + kScenes + "space/cube.json' --methods exact --divide 1,2,3,4 --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("mean radiosities of faces by exact factors:"));
  const auto lines = lines_of(place.read("out/divide_faces.csv"));
  EXPECT_EQ(lines.size(), 1u + 6 * 4);
  EXPECT_THAT(lines[4], HasSubstr("exact,floor,all,4,"));
  EXPECT_NEAR(std::stod(fields_of(lines[4])[5]), 1.8, 0.4);
}

TEST(Compare, TellsACommandTheDivision) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare +
                                    "' --methods 'mine=run:hottel factors {scene} --per element --elements "
                                    "{elements} --quiet -o {out}' --divide 1,3 --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(place.read("out/divide.csv"));
  ASSERT_EQ(lines.size(), 5u);
  for (const std::size_t line : {2u, 4u}) {
    const auto fields = fields_of(lines[line]);
    EXPECT_EQ(fields[2], "mine");
    EXPECT_EQ(fields[5], "0");
  }
}

TEST(Compare, HoldsLightOnAGridAgainstTheExactOne) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel solve '" + kSquare + "' --grid 8x6 -o solved --quiet").code, 0);
  Outcome outcome = place.run("hottel compare '" + kSquare + "' --grid-file solved/illumination.npy -o out --repeat 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto fields = fields_of(lines_of(place.read("out/grid.csv")).at(1));
  EXPECT_EQ(fields[0], "all");
  EXPECT_EQ(fields[1], "48");
  EXPECT_EQ(fields[4], "0");
  EXPECT_EQ(lines_of(place.read("out/compare.csv")).size(), 2u) << "exact alone";
  EXPECT_THAT(place.read("out/grid_errors.png"), StartsWith("\x89PNG"));

  // One cell is wrong: the last number of the file, of the cell at the right and at the top.
  ASSERT_EQ(
      place.run("head -c -8 solved/illumination.npy > wrong.npy; printf '\\0\\0\\0\\0\\0\\0\\360\\077' >> wrong.npy")
          .code,
      0);
  outcome = place.run("hottel compare '" + kSquare + "' --grid-file wrong.npy -o out --repeat 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  fields = fields_of(lines_of(place.read("out/grid.csv")).at(1));
  EXPECT_EQ(fields[7] + "," + fields[8], "7,5");
  EXPECT_EQ(fields[12], "1");
  EXPECT_THAT(outcome.err, HasSubstr("1 of 48 cells is off by 0.594, "));
  EXPECT_THAT(outcome.err, HasSubstr("the worst is cell 7, 5"));
  outcome = place.run("hottel compare '" + kSquare + "' --grid-file wrong.npy --beyond 2 -o out --repeat 1");
  EXPECT_THAT(outcome.err, HasSubstr("all 48 cells agree with the exact light within 2 of the largest"));
}

TEST(Compare, HoldsLightOnAGridInSpaceAgainstTheExactOne) {
  const Workplace place;
  place.write("grid.json", R"({"hottel": 1, "dimension": 3,
    "materials": {"lamp": {"emission": 1}, "wall": {"reflectivity": 0.5}},
    "polygons": [
      {"name": "lamp", "points": [[0,0,2],[0,2,2],[2,2,2],[2,0,2]], "material": "lamp"},
      {"name": "floor", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "wall"}],
    "grid": {"origin": ["0.5", "0.5", 1], "u": [1,0,0], "v": [0,1,0], "cells": [4, 3]}})");
  ASSERT_EQ(place.run("hottel solve grid.json -o solved --quiet").code, 0);
  const std::string compare = "hottel compare grid.json --methods center --repeat 1 -o out --grid-file ";
  ASSERT_EQ(place.run(compare + "solved/illumination.npy").code, 0);
  auto fields = fields_of(lines_of(place.read("out/grid.csv")).at(1));
  EXPECT_EQ(fields[1], "12");
  EXPECT_EQ(fields[4], "0");
  // The last cell is dark.
  ASSERT_EQ(
      place.run("head -c -8 solved/illumination.npy > dark.npy; printf '\\0\\0\\0\\0\\0\\0\\0\\0' >> dark.npy").code,
      0);
  const Outcome outcome = place.run(compare + "dark.npy");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  fields = fields_of(lines_of(place.read("out/grid.csv")).at(1));
  EXPECT_EQ(fields[7] + "," + fields[8], "3,2");
  EXPECT_EQ(fields[9] + "," + fields[11], "1.375,1") << "x and z of its centre";
  EXPECT_EQ(fields[12], "0");
  EXPECT_THAT(outcome.err, HasSubstr("the worst is cell 3, 2"));
}

// Numbers of something else would be told to be errors.
TEST(Compare, RefusesNumbersThatAreNoLightAtCentres) {
  const Workplace place;
  place.write("room.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
    "polygons": [{"name": "f", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "m"}],
    "grid": {"origin": [0,0,1], "u": [2,0,0], "v": [0,1,0], "cells": [4, 3]}})");
  const auto said = [&](const std::string& scene, const std::string& options, const std::string& file) {
    EXPECT_EQ(place.run("hottel solve '" + scene + "' -o solved --quiet " + options).code, 0);
    const Outcome outcome = place.run("hottel compare '" + scene + "' --repeat 1 -o out --grid-file solved/" + file);
    EXPECT_EQ(outcome.code, 3) << options;
    return outcome.err;
  };
  EXPECT_THAT(said(kSquare, "--grid 8x6 --illumination average", "illumination.npy"),
              StartsWith("solved/illumination.npy.json: says that the numbers are 'mean irradiance' by 'average', and "
                         "what is compared is the mean irradiance at the centres of cells"));
  EXPECT_THAT(said(kSquare, "--grid 8x6 --show irradiance", "shown.npy"), HasSubstr("says that the numbers are '"));
  EXPECT_THAT(said("room.json", "--illumination average", "illumination.npy"), HasSubstr("'irradiance' by 'average'"));
  EXPECT_EQ(place
                .run("hottel solve room.json -o solved --quiet && "
                     "sed -i 's/\"origin\": .0,0,1./\"origin\": [0,0,1.5]/' room.json")
                .code,
            0);
  const Outcome moved = place.run("hottel compare room.json --repeat 1 -o out --grid-file solved/illumination.npy");
  EXPECT_EQ(moved.code, 3);
  EXPECT_THAT(moved.err, StartsWith("solved/illumination.npy.json: says that the grid lies elsewhere"));
}

TEST(Compare, RefusesGridsThatDoNotFit) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel solve '" + kSquare + "' --grid 8x6 -o solved --quiet && hottel factors '" + kSquare +
                     "' --quiet -o f.csv && cp solved/illumination.npy a.npy && sed 's/0.0/-7.0/' "
                     "solved/illumination.npy.json > a.npy.json")
                .code,
            0);
  const auto said = [&](const std::string& file) {
    const Outcome outcome = place.run("hottel compare '" + kSquare + "' --grid-file " + file + " -o out --repeat 1");
    EXPECT_EQ(outcome.code, 3) << file;
    return outcome.err;
  };
  EXPECT_THAT(said("f.csv"), HasSubstr("f.csv: is no array of NumPy"));
  EXPECT_THAT(said("a.npy"), HasSubstr("a.npy.json: says that the grid lies elsewhere"));
  EXPECT_THAT(said("none.npy"), StartsWith("none.npy: "));
  ASSERT_EQ(place.run("sed 's/(6, 8, 1)/(6, 4, 2)/' solved/illumination.npy > two.npy").code, 0);
  EXPECT_EQ(said("two.npy"),
            "two.npy: has 2 values a cell, and the light of the scene one\n  its shape has to be (6, 4)\n");
}

// A scene that says how many cells there are has no others.
TEST(Compare, RefusesGridsOfAnotherShapeThanTheScenes) {
  const Workplace place;
  const auto flat = [](const char* cells) {
    return std::string(R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
      "polylines": [{"name": "room", "points": [[0, 0], [0, 2], [4, 2], [4, 0]], "closed": true, "material": "m"}])") +
           cells + "}";
  };
  const auto solid = [](const char* grid) {
    return std::string(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
      "polygons": [{"name": "f", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "m"}])") +
           grid + "}";
  };
  const char* const at = R"(, "grid": {"origin": [0,0,1], "u": [2,0,0], "v": [0,1,0], "cells": )";
  place.write("own.json", flat(R"(, "grid": {"min": [0, 0], "max": [4, 2], "cells": [8, 4]})"));
  place.write("none.json", flat(""));
  place.write("space.json", solid((std::string(at) + "[4, 3]}").c_str()));
  place.write("turned.json", solid((std::string(at) + "[3, 4]}").c_str()));
  place.write("bare.json", solid(""));
  const auto solved = [&](const std::string& scene, const std::string& options) {
    const std::string out = scene.substr(0, scene.find('.'));
    ASSERT_EQ(place.run("hottel solve " + scene + " " + options + " -o " + out + " --quiet").code, 0);
  };
  solved("own.json", "");
  solved("none.json", "--grid 4x8");
  solved("turned.json", "");
  solved("space.json", "");
  const auto said = [&](const std::string& scene, const std::string& file, int code) {
    const Outcome outcome = place.run("hottel compare " + scene + " --methods exact --grid-file " + file +
                                      "/illumination.npy -o out --repeat 1");
    EXPECT_EQ(outcome.code, code) << scene << " " << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("--grid ")));
    return outcome.err;
  };
  said("own.json", "own", 0);
  EXPECT_THAT(said("own.json", "none", 3),
              HasSubstr("none/illumination.npy: has the shape (8, 4), and the grid of the scene (4, 8): the axes are "
                        "exchanged"));
  said("space.json", "space", 0);
  EXPECT_THAT(said("space.json", "turned", 3),
              HasSubstr("has the shape (4, 3), and the grid of the scene (3, 4): the axes are"));
  EXPECT_THAT(said("space.json", "own", 3), HasSubstr("has the shape (4, 8), and the grid of the scene (3, 4)\n"));
  EXPECT_THAT(said("bare.json", "space", 3),
              HasSubstr("space/illumination.npy: is light on a grid, and the scene does not say where one lies"));
  said("none.json", "none", 0);
}

TEST(Compare, DrawsWhereAnExternalRadiosityIsWrong) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel solve '" + kSquare + "' --grid 2x2 -o solved --quiet").code, 0);
  const Outcome outcome = place.run("hottel compare '" + kSquare +
                                    "' --methods mine=file:solved/radiosity.csv --map mine --repeat 1 -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("out/errors.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(outcome.err, HasSubstr("the plot is of errors of radiosities, which all have"));
  EXPECT_THAT(place.read("out/compare.svg"), HasSubstr("largest error of a radiosity"));
  EXPECT_THAT(place.read("out/compare.svg"), HasSubstr("mine"));
  ASSERT_EQ(place
                .run("hottel compare '" + kSquare +
                     "' --methods mine=file:solved/radiosity.csv,gauss:2 --plot-y max --repeat 1 -o out")
                .code,
            0);
  EXPECT_THAT(place.read("out/compare.svg"), HasSubstr("largest error of a view factor"));
}

TEST(Compare, RefusesMethodsThatThereAreNotBeforeItWritesAnything) {
  const Workplace place;
  const Outcome outcome = place.run("hottel compare '" + kSquare + "' --methods exact,guess");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("there is no method called 'guess' in the plane; there are exact"));
  EXPECT_TRUE(place.files().empty());
  EXPECT_EQ(place.run("hottel compare '" + kSquare + "' --repeat 0").code, 2);
  EXPECT_EQ(place.run("hottel compare").code, 2);
  EXPECT_EQ(place.run("hottel compare nothing.json").code, 3);
}

TEST(Compare, LeavesEarlierFilesAsTheyAreWhenItFails) {
  const Workplace place;
  ASSERT_EQ(place.run("mkdir out && echo before > out/compare.csv && mkdir out/worst.csv").code, 0);
  EXPECT_EQ(place.run("hottel compare '" + kSquare + "' --methods exact --repeat 1 -o out").code, 3);
  EXPECT_EQ(place.read("out/compare.csv"), "before\n");
}

}  // namespace
}  // namespace hottel::compare_test
