// Scenes in space at the command line: what works, and that all else says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::space_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string scene_file(const std::string& name) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name; }

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0.1 0\nusemtl oak\nf 1 2 3\n";

TEST(Space, EdgesOfThePlaneAreRefusedAsWrongUseWithWhatSpaceHas) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  const Outcome outcome = place.run("hottel visibility room.json --edge floor");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("in space --face NAME tells what some point of a face sees"));
}

TEST(Space, FacesSeeAndCornersSeeEachOther) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  EXPECT_EQ(lines_of(place.run("hottel visibility room.json --face floor").out).size(), 6u);
  const Outcome graph = place.run("hottel visibility room.json --graph -o graph.csv");
  EXPECT_EQ(graph.err, "8 vertices; 28 pairs that see each other, 12 of them along edges\n");
  EXPECT_EQ(lines_of(place.read("graph.csv"))[1], "0,1,0,0,0,1,0,0,1,floor,floor,floor");
}

TEST(Space, EventsAreWrittenAsTableAndForParaView) {
  const Workplace place;
  place.write("boxes.json", contents(scene_file("two_boxes.json")));
  const Outcome csv = place.run("hottel visibility boxes.json --events --from lamp --to floor");
  ASSERT_EQ(csv.code, 0) << csv.err;
  EXPECT_THAT(csv.err, HasSubstr("through an edge and a vertex (EV)"));
  EXPECT_GT(lines_of(csv.out).size(), 100u);
  ASSERT_EQ(place.run("hottel visibility boxes.json --events --from lamp --to floor -o events.vtp").code, 0);
  EXPECT_THAT(place.read("events.vtp"), HasSubstr("<VTKFile type=\"PolyData\""));
}

TEST(Space, PointsOfThePlaneAreRefusedByTheirFile) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  place.write("room.obj", kTriangle);
  place.write("p.csv", "x,y\n1,1\n");
  const std::vector<std::string> before = place.files();
  for (const std::string scene : {"room.json", "room.obj"}) {
    const Outcome outcome = place.run("hottel visibility " + scene + " --points p.csv");
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "p.csv: points have two coordinates, and " + scene + " is in space: give x,y,z\n");
  }
  EXPECT_EQ(place.files(), before);
}

// From the middle of a cube each face has a sixth of all directions; in a corner of nothing but the sky, all.
TEST(Space, PointsSeeFacesAsLargeAsTheirAnglesAre) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  place.write("p.csv", "x,y,z\n0.5, 1/2 ,0.5\n0.5,0.5,1/4\n");
  const Outcome outcome = place.run("hottel visibility room.json --points p.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 13u);
  EXPECT_EQ(lines[0], "point,x,y,z,face,fraction,solid_angle");
  double sum = 0;
  for (std::size_t k = 1; k <= 6; ++k)
    EXPECT_NEAR(std::stod(lines[k].substr(lines[k].rfind(',') + 1)), 2 * std::numbers::pi / 3, 1e-14) << lines[k];
  for (std::size_t k = 7; k <= 12; ++k) {
    EXPECT_THAT(lines[k], StartsWith("1,0.5,0.5,0.25,"));
    sum += std::stod(lines[k].substr(lines[k].rfind(',') + 1));
  }
  EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-13);
}

// Proven: the same faces, each number within bounds a few units of the last place apart.
TEST(Space, PointsSeeFacesWithinProvenBounds) {
  const Workplace place;
  place.write("room.json", contents(scene_file("two_boxes.json")));
  place.write("p.csv", "1,1,1.5\n3,2.5,0.25\n1/3,1/7,2\n");
  const Outcome plain = place.run("hottel visibility room.json --points p.csv");
  const Outcome proven = place.run("hottel visibility room.json --points p.csv --guarantee enclosed");
  ASSERT_EQ(proven.code, 0) << proven.err;
  const std::vector<std::string> before = lines_of(plain.out), lines = lines_of(proven.out);
  ASSERT_EQ(lines.size(), before.size());
  EXPECT_EQ(lines[0], "point,x,y,z,face,fraction,lower,upper,solid_angle");
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::vector<std::string> cells = testing_cli::cells_of(lines[k]), then = testing_cli::cells_of(before[k]);
    ASSERT_EQ(cells.size(), 9u);
    EXPECT_EQ(cells[4], then[4]);
    const double fraction = std::stod(cells[5]), lower = std::stod(cells[6]), upper = std::stod(cells[7]);
    EXPECT_LT(lower, upper);
    EXPECT_LE(lower, fraction);
    EXPECT_GE(upper, fraction);
    EXPECT_LE(upper - lower, 1e-15 * fraction);
    EXPECT_NEAR(fraction, std::stod(then[5]), 1e-14);
    EXPECT_EQ(std::stod(cells[8]), 4 * std::numbers::pi * fraction);
  }
}

TEST(Space, PointsOfSpaceThatAreWrongAreRefused) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  place.write("flat.json", contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/triangle_345.json"));
  for (const auto& [line, message] :
       {std::pair("printf '1,1,1\\n1,1\\n' | hottel visibility room.json --points -", "three coordinates x,y,z, not 2"),
        {"echo 1,1,a | hottel visibility room.json --points -", "is no number"},
        {"echo x,y,z | hottel visibility room.json --points -", "there is no point in it"},
        {"echo id,x,y,z | hottel visibility room.json --points -", "'id,x,y,z' is no first line that is known"},
        {"printf 'id,x,y\\nA,1,2\\n' | hottel visibility flat.json --points -",
         "'id,x,y' is no first line that is known"},
        {"echo 1,1,1 | hottel visibility flat.json --points -", "flat.json is in the plane"}}) {
    const Outcome outcome = place.run(line);
    EXPECT_EQ(outcome.code, 3) << line;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << line;
    EXPECT_EQ(outcome.out, "") << line;
  }
}

TEST(Space, APlaceBesideAFaceIsToldWhereItIs) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  const Outcome outcome = place.run("hottel visibility room.json --on floor --at 2,2");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--at 2,2 is no point of 'floor': it is ("));
  EXPECT_THAT(outcome.err, HasSubstr(", S along the first side, T along the last\n"));
}

// The fractions of the faces and the sky that the text tells.
std::vector<double> fractions(const std::string& text) {
  std::vector<double> result;
  for (const std::string& line : lines_of(text))
    if (line.starts_with("  0.") || line.starts_with("  1 ") || line.starts_with("  0 "))
      result.push_back(std::stod(line));
  return result;
}

TEST(Space, APointSeesEachWallOfACubeAlike) {
  const Workplace place;
  const Outcome outcome = place.run("hottel visibility '" + scene_file("cube.json") + "' --at 1/2,1/2,1/2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("from (1/2,1/2,1/2)"));
  const std::vector<double> seen = fractions(outcome.out);
  ASSERT_GE(seen.size(), 6u) << outcome.out;
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(seen[k], 1.0 / 6, 1e-15);
}

// Every direction that does not lead into a solid is seen: of a cube half of them from a face, three quarters from an
// edge, seven eighths from a corner; and what is within is no face's.
TEST(Space, APointOnTheBorderOfASolidSeesAllThatIsFree) {
  const Workplace place;
  place.write("box.json", R"({"hottel": 1, "dimension": 3, "materials": {"w": {"reflectivity": 0.5}}, "polygons": [
 {"name": "bot", "group": "g", "points": [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]], "material": "w"},
 {"name": "top", "group": "g", "points": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], "material": "w"},
 {"name": "sou", "group": "g", "points": [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], "material": "w"},
 {"name": "nor", "group": "g", "points": [[1, 1, 0], [0, 1, 0], [0, 1, 1], [1, 1, 1]], "material": "w"},
 {"name": "wes", "group": "g", "points": [[0, 1, 0], [0, 0, 0], [0, 0, 1], [0, 1, 1]], "material": "w"},
 {"name": "eas", "group": "g", "points": [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]], "material": "w"},
 {"name": "floor", "points": [[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]], "material": "w"}]})");
  // Below the edges of the box the floor is seen all around, and nothing of what the box covers.
  for (const auto& [at, solid, floor] : {std::tuple{"0.5,0,0.5", 0.5, 0.2}, std::tuple{"0,0,0.5", 0.25, 0.29},
                                         std::tuple{"0,0,1", 0.125, 0.29}, std::tuple{"0.5,0.5,1", 0.5, 0.0}}) {
    const Outcome outcome = place.run(std::string("hottel visibility box.json --json --at ") + at);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto answer = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(answer["solids"].size(), 1u) << at;
    EXPECT_EQ(answer["solids"][0]["solid"], "g") << at;
    EXPECT_NEAR(answer["solids"][0]["fraction"].get<double>(), solid, 1e-14) << at;
    double sum = solid + answer["sky"]["fraction"].get<double>();
    for (const auto& face : answer["faces"]) {
      EXPECT_EQ(face["name"], "floor") << at;
      EXPECT_GE(face["fraction"].get<double>(), floor) << at;
      sum += face["fraction"].get<double>();
    }
    EXPECT_EQ(answer["faces"].size(), floor > 0 ? 1u : 0u) << at;
    EXPECT_NEAR(sum, 1, 1e-14) << at;
  }
  EXPECT_THAT(place.run("hottel visibility box.json --at 0,0,1").out, HasSubstr("(in the solid 'g')"));
  EXPECT_EQ(place.run("hottel visibility box.json --at 0,0,1 -o seen.png").code, 0);
}

TEST(Space, APointOfAFaceHasViewFactors) {
  const Workplace place;
  const std::string scene = "'" + scene_file("cube.json") + "'";
  const Outcome in_frame = place.run("hottel visibility " + scene + " --on floor --at 1/2,1/2 --json");
  ASSERT_EQ(in_frame.code, 0) << in_frame.err;
  const Outcome in_space = place.run("hottel visibility " + scene + " --on floor --at 1/2,1/2,0 --json");
  EXPECT_EQ(in_space.out, in_frame.out);
  const auto json = nlohmann::json::parse(in_frame.out);
  ASSERT_EQ(json["faces"].size(), 5u);
  double sum = 0;
  for (const auto& face : json["faces"]) sum += face["factor"].get<double>();
  EXPECT_NEAR(sum, 1, 1e-14);
  // The middle of a unit square sees a parallel one at distance 1: 4 times that of a corner (Hottel's rectangle).
  const double root = std::sqrt(1.25), arc = std::atan(0.5 / root);
  const double expected = 4 / (2 * std::numbers::pi) * 2 * (0.5 / root) * arc;
  for (const auto& face : json["faces"]) {
    if (face["name"] == "ceiling") {
      EXPECT_NEAR(face["factor"].get<double>(), expected, 1e-14);
    }
  }
}

TEST(Space, WhatAPointSeesIsProvenWhereAskedFor) {
  const Workplace place;
  const std::string command = "hottel visibility '" + std::string(HOTTEL_SOURCE_DIR) +
                              "/scenes/space/two_boxes.json' --on floor --at 4/5,1/2 --json";
  const auto usual = nlohmann::json::parse(place.run(command).out),
             proven = nlohmann::json::parse(place.run(command + " --guarantee enclosed").out);
  ASSERT_EQ(usual["faces"].size(), proven["faces"].size());
  for (std::size_t k = 0; k < usual["faces"].size(); ++k) {
    const auto &before = usual["faces"][k], &after = proven["faces"][k];
    EXPECT_FALSE(before.contains("bounds"));
    EXPECT_EQ(before["name"], after["name"]);
    for (const char* number : {"factor", "fraction"}) {
      const double value = after[number], lower = after["bounds"][number][0], upper = after["bounds"][number][1];
      EXPECT_NEAR(value, before[number].get<double>(), 1e-14);
      EXPECT_LE(lower, value);
      EXPECT_LE(value, upper);
      EXPECT_LE(upper - lower, 4e-16 * value);
    }
  }
  // The room is closed: doubles leave a rest of rounding, what is proven does not.
  EXPECT_EQ(proven["sky"]["factor"], 0);
  EXPECT_LT(proven["sky"]["bounds"]["factor"][1], 1e-30);
}

TEST(Space, AMapIsDrawnInBothFormats) {
  const Workplace place;
  const std::string line = "hottel visibility '" + scene_file("room_boxes.obj") + "' --at 0.6,0.25,1.6 --quiet -o ";
  EXPECT_EQ(place.run(line + "map.png").code, 0);
  EXPECT_EQ(place.run(line + "map.svg").code, 0);
  EXPECT_TRUE(place.read("map.png").starts_with("\x89PNG"));
  EXPECT_THAT(place.read("map.svg"), HasSubstr("<svg"));
}

TEST(Space, PointsThatMakeNoSenseAreRefused) {
  const Workplace place;
  const std::string scene = "hottel visibility '" + scene_file("cube.json") + "' ";
  for (const char* asked :
       {"--at 1,1", "--at 1,x,1", "--at 1,1,1,1", "--on floor --at 1/2", "--on floor --at 2,0",
        "--on floor --at 1/2,1/2,1/2", "--on sky --at 1,1", "--on nowhere --at 1,1", "--at 1/2,1/2,1/2 -o map.txt"}) {
    const Outcome outcome = place.run(scene + asked);
    EXPECT_EQ(outcome.code, 2) << asked << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << asked;
  }
}

TEST(Space, ScenesAreRewrittenExactly) {
  const Workplace place;
  for (const char* name : {"cube.json", "two_boxes.json", "room_boxes.json", "room_boxes.obj"}) {
    const Outcome outcome =
        place.run("hottel convert '" + scene_file(name) + "' a.json && hottel convert a.json b.json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << name;
    EXPECT_EQ(place.read("a.json"), place.read("b.json")) << name;
  }
}

TEST(Space, AMeshWithoutMaterialsIsGivenSomeAndItIsSaid) {
  const Workplace place;
  place.write("table.obj", kTriangle);
  const Outcome outcome = place.run("hottel convert table.obj -");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("\"oak\": {\"reflectivity\": 0.5}"));
  EXPECT_THAT(outcome.out,
              HasSubstr("{\"name\": \"table[0]\", \"group\": \"table\", \"points\": [[0, 0, 0], [1, 0, 0], "
                        "[0, 0.1, 0]], \"material\": \"oak\"}"));
  EXPECT_EQ(outcome.err, "1 polygon; reflectivity 0.5 for: oak (the mesh does not say; edit \"materials\")\n");
}

TEST(Space, WrongMeshesEndWithThreeAndNameFileLineAndFace) {
  const Workplace place;
  place.write("old.json", "old");
  place.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\ng box\nf 1 2 3 4\n");
  place.write("scene.json",
              "{\"hottel\": 1, \"dimension\": 3, \"materials\": {\"m\": {}},\n"
              "\"mesh\": {\"file\": \"bad.obj\", \"material\": \"m\"}}\n");
  place.write("lost.json", "{\"hottel\": 1, \"dimension\": 3, \"mesh\": {\"file\": \"lost.obj\"}}\n");
  for (const char* file : {"bad.obj", "scene.json"}) {
    const Outcome outcome = place.run(std::string("hottel convert ") + file + " old.json");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, StartsWith("bad.obj:6: face 'box[0]' is not plane: points lie "));
    EXPECT_EQ(lines_of(outcome.err).size(), 2u);
  }
  const Outcome outcome = place.run("hottel convert lost.json old.json");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "lost.json:1: mesh 'mesh[0]': the file lost.obj: there is no such file\n");
  EXPECT_EQ(place.read("old.json"), "old");
  for (const char* ending : {"stl", "ply", "off", "obj", "vs3"}) {
    const Outcome missing = place.run(std::string("hottel plan a.") + ending);
    EXPECT_EQ(missing.code, 3);
    EXPECT_EQ(missing.err, std::string("a.") + ending + ": there is no such file\n");
  }
}

TEST(Space, WhatIsNotPlaneBecomesTrianglesWhereAskedFor) {
  const Workplace place;
  // A room of which one corner is lifted: its ceiling is bent along a ridge and sees itself.
  place.write("room.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "closed": true,
    "polygons": [
      {"name": "floor", "points": [[0,0,0], [1,0,0], [1,1,0], [0,1,0]], "material": "m"},
      {"name": "ceiling", "points": [[0,0,1], [0,1,1], [1,1,1.25], [1,0,1]], "material": "m"},
      {"name": "west", "points": [[0,0,0], [0,1,0], [0,1,1], [0,0,1]], "material": "m"},
      {"name": "east", "points": [[1,0,0], [1,0,1], [1,1,1.25], [1,1,0]], "material": "m"},
      {"name": "south", "points": [[0,0,0], [0,0,1], [1,0,1], [1,0,0]], "material": "m"},
      {"name": "north", "points": [[0,1,0], [1,1,0], [1,1,1.25], [0,1,1]], "material": "m"}]})");
  const Outcome refused = place.run("hottel factors room.json");
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("polygon 'ceiling' is not plane"));
  EXPECT_THAT(refused.err, HasSubstr("--triangulate"));
  const Outcome factors = place.run("hottel factors room.json --triangulate");
  EXPECT_EQ(factors.code, 0) << factors.err;
  EXPECT_THAT(factors.err, StartsWith("'ceiling' is not plane: points lie "));
  EXPECT_THAT(factors.err, HasSubstr("; it is read as 2 triangles\n"));
  EXPECT_THAT(factors.out, HasSubstr("\nceiling[0],ceiling[1],"));
  std::map<std::string, double> sums;
  for (const std::string& line : lines_of(factors.out)) {
    if (line.starts_with("from,")) continue;
    const std::size_t comma = line.find(',');
    EXPECT_THAT(line, Not(HasSubstr(",sky,")));
    sums[line.substr(0, comma)] += std::stod(line.substr(line.find(',', comma + 1) + 1));
  }
  EXPECT_EQ(sums.size(), 7u);
  for (const auto& [name, sum] : sums) EXPECT_NEAR(sum, 1, 1e-14) << name;
  EXPECT_THAT(place.run("hottel factors room.json --triangulate --per group --quiet").out,
              HasSubstr("\nceiling,ceiling,"));
  for (const char* command : {"check", "plan", "visibility --at 0.5,0.5,0.5"}) {
    const std::string words = std::string("hottel ") + command + " room.json";
    EXPECT_EQ(place.run(words).code, 3) << words;
    EXPECT_EQ(place.run(words + " --triangulate").code, 0) << words;
  }
  const Outcome fixed = place.run("hottel check room.json --triangulate --fix fixed.json --within 1e-6");
  EXPECT_EQ(fixed.code, 0) << fixed.err;
  EXPECT_EQ(place.run("hottel factors fixed.json --quiet").code, 0);
}

// A room whose ceiling is off its plane by the last digit of the file.
constexpr const char* kNearlyPlane = R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
  "closed": true, "polygons": [
    {"name": "floor", "points": [[0,0,0], [1,0,0], [1,1,0], [0,1,0]], "material": "m"},
    {"name": "ceiling", "points": [[0,0,1], [0,1,1], [1,1,1.0001], [1,0,1]], "material": "m"},
    {"name": "west", "points": [[0,0,0], [0,1,0], [0,1,1], [0,0,1]], "material": "m"},
    {"name": "east", "points": [[1,0,0], [1,0,1], [1,1,1.0001], [1,1,0]], "material": "m"},
    {"name": "south", "points": [[0,0,0], [0,0,1], [1,0,1], [1,0,0]], "material": "m"},
    {"name": "north", "points": [[0,1,0], [1,1,0], [1,1,1.0001], [0,1,1]], "material": "m"}]})";

TEST(Space, WhatRoundingHasBentIsTakenAsItStands) {
  const Workplace place;
  place.write("room.json", kNearlyPlane);
  const Outcome factors = place.run("hottel factors room.json");
  EXPECT_EQ(factors.code, 0) << factors.err;
  std::map<std::string, double> sums;
  for (const std::string& line : lines_of(factors.out)) {
    if (line.starts_with("from,")) continue;
    const std::size_t comma = line.find(',');
    sums[line.substr(0, comma)] += std::stod(line.substr(line.find(',', comma + 1) + 1));
  }
  EXPECT_EQ(sums.size(), 6u);
  for (const auto& [name, sum] : sums) EXPECT_NEAR(sum, 1, 1e-14) << name;
  // Its corner is lifted: it has a ridge, seen from above, and sees itself from below.
  EXPECT_THAT(factors.out, HasSubstr("\nceiling,ceiling,"));
  EXPECT_EQ(place.run("hottel factors room.json --triangulate").out, factors.out);
  const Outcome check = place.run("hottel check room.json");
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out + check.err, HasSubstr("'ceiling' is not plane: (0, 0, 1) lies "));
  EXPECT_EQ(place.run("hottel plan room.json").code, 0);
  for (const char* at : {"0.9,0.2", "0.2,0.9", "0.5,0.5"}) {
    const Outcome seen = place.run(std::string("hottel visibility room.json --on ceiling --at ") + at);
    EXPECT_EQ(seen.code, 0) << seen.err;
    EXPECT_THAT(seen.out, HasSubstr("floor"));
  }
  EXPECT_EQ(place.run("hottel visibility room.json --on ceiling --at 0.25,0.5,1.000025").code, 0);
  EXPECT_EQ(place.run("hottel visibility room.json --on ceiling --at 0.25,0.5,1").code, 2);
  EXPECT_EQ(place.run("hottel visibility room.json --from ceiling --to floor").code, 0);
  EXPECT_EQ(place.run("hottel factors room.json --elements 2 --per element").code, 0);
  for (const char* file : {"room.obj", "room.ply", "room.off", "again.json"}) {
    EXPECT_EQ(place.run(std::string("hottel convert room.json ") + file).code, 0);
    const Outcome again = place.run(std::string("hottel factors --matrix factor ") + file);
    EXPECT_EQ(again.code, 0) << file << again.err;
    EXPECT_EQ(lines_of(again.out).size(), 14u) << file;
  }
  // A deck has triangles, combined.
  EXPECT_EQ(place.run("hottel convert room.json room.vs3").code, 0);
  EXPECT_EQ(lines_of(place.run("hottel factors --matrix factor room.vs3").out).size(), 14u);
  EXPECT_EQ(place.run("hottel check room.json --fix fixed.json --within 1e-6").code, 0);
  EXPECT_EQ(place.run("hottel factors fixed.json").out, factors.out);
  std::string more = kNearlyPlane;
  for (std::size_t at; (at = more.find("1.0001")) != std::string::npos;) more.replace(at, 6, "1.0003");
  place.write("more.json", more);
  EXPECT_EQ(place.run("hottel factors more.json").code, 3) << "this is more than 1e-4 of its diameter";
}

TEST(Space, BinaryFloatsHaveTheirSpacingAndDecimalsDoNot) {
  const Workplace place;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  // Of a plane that leans by a third along x and a seventh along y.
  for (const auto& [x, y] :
       {std::pair(0.1F, 0.2F), std::pair(1.3F, 0.1F), std::pair(1.2F, 1.7F), std::pair(0.3F, 1.1F)})
    for (const float value : {x, y, x / 3 + y / 7}) bytes.append(reinterpret_cast<const char*>(&value), 4);
  bytes += '\4';
  for (const std::int32_t index : {0, 1, 2, 3}) bytes.append(reinterpret_cast<const char*>(&index), 4);
  place.write("leaning.ply", bytes);
  const Outcome check = place.run("hottel check leaning.ply");
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out + check.err, HasSubstr("is not plane"));
  EXPECT_EQ(place.run("hottel factors leaning.ply").code, 0);
  const Outcome convert = place.run("hottel convert leaning.ply leaning.json");
  EXPECT_EQ(convert.code, 0);
  EXPECT_THAT(convert.err, HasSubstr("as decimals, which have more digits, these are not plane: 'leaning[0]'"));
  EXPECT_EQ(place.run("hottel factors leaning.json").code, 3);
  EXPECT_EQ(place.run("hottel factors leaning.json --triangulate").code, 0);
}

TEST(Space, MeshesAndDecksThatAreNotPlaneBecomeTrianglesToo) {
  const Workplace place;
  place.write("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\ng box\nf 1 2 3 4\nf 1 2 3\n");
  place.write("scene.json", R"({"hottel": 1, "dimension": 3, "materials": {"white": {"reflectivity": 0.5}},
    "mesh": {"file": "bent.obj", "material": "white", "scale": 2}})");
  place.write("bent.vs3",
              "T bent\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 .25\nV 4 0 1 0\nV 5 0 0 1\nV 6 0 1 1\nV 7 1 1 1\nV 8 1 0 1\n"
              "S 1 1 2 3 4 0 0 .5 a\nS 2 5 6 7 8 0 0 .5 b\nEnd of data\n");
  for (const char* file : {"bent.obj", "scene.json"}) {
    const Outcome outcome = place.run(std::string("hottel convert --triangulate ") + file + " -");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\"box[0][0]\""));
    EXPECT_THAT(outcome.out, HasSubstr("\"box[0][1]\""));
    EXPECT_THAT(outcome.out, HasSubstr("\"box[1]\""));
    EXPECT_THAT(outcome.err, StartsWith("'box[0]' is not plane: points lie "));
  }
  EXPECT_EQ(place.run("hottel convert --triangulate bent.obj flat.stl").code, 0);
  EXPECT_EQ(place.run("hottel convert --triangulate scene.json flat.ply").code, 0);
  EXPECT_EQ(place.run("hottel convert --triangulate bent.obj flat.vs3").code, 0);
  EXPECT_EQ(place.run("hottel factors bent.vs3").code, 3);
  const Outcome deck = place.run("hottel factors bent.vs3 --triangulate --quiet");
  EXPECT_EQ(deck.code, 0) << deck.err;
  EXPECT_THAT(deck.out, HasSubstr("\na,b,"));
  EXPECT_THAT(deck.out, Not(HasSubstr("\na,a,")));  // it is bent along a ridge, away from itself
  EXPECT_THAT(deck.out, HasSubstr("\nb,a,"));
}

}  // namespace
}  // namespace hottel::space_test
