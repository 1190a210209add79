// Scenes in space at the command line: what works, and that all else says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/cli/program.h"

namespace hottel {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string scene_file(const std::string& name) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name; }

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0.1 0\nusemtl oak\nf 1 2 3\n";

TEST(Space, CommandsOfThePlaneRefuseItWithThreeAndSayWhatWorks) {
  const Workplace place;
  place.write("room.json", contents(scene_file("cube.json")));
  place.write("room.obj", kTriangle);
  const std::vector<std::string> before = place.files();
  for (const char* command : {"solve S -o out", "visibility S --events", "compare S --methods exact,center -o out",
                              "reference out S", "view S --screenshot a.png"})
    for (const char* scene : {"room.json", "room.obj"}) {
      std::string line = std::string("hottel ") + command;
      line.replace(line.find('S'), 1, scene);
      const Outcome outcome = place.run(line);
      EXPECT_EQ(outcome.code, 3) << line << "\n" << outcome.err;
      EXPECT_EQ(outcome.out, "") << line;
      const std::vector<std::string> lines = lines_of(outcome.err);
      ASSERT_EQ(lines.size(), 2u) << line << "\n" << outcome.err;
      EXPECT_EQ(lines[0], std::string(scene) + (scene == std::string("room.json") ? ":3" : "") +
                              ": the scene is in space (dimension 3); this command works in the plane")
          << line;
      EXPECT_THAT(lines[1], HasSubstr("`hottel convert`")) << line;
    }
  EXPECT_EQ(place.files(), before);
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
  EXPECT_EQ(outcome.err, "1 polygons; reflectivity 0.5 for: oak (the mesh does not say; edit \"materials\")\n");
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
  EXPECT_THAT(outcome.err, StartsWith("lost.obj: "));
  EXPECT_EQ(place.read("old.json"), "old");
  for (const char* ending : {"stl", "ply", "off", "obj", "vs3"}) {
    const Outcome missing = place.run(std::string("hottel plan a.") + ending);
    EXPECT_EQ(missing.code, 3);
    EXPECT_EQ(missing.err, std::string("a.") + ending + ": there is no such file\n");
  }
}

}  // namespace
}  // namespace hottel
