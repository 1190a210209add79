// Scenes in space at the command line: what works, and that all else says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  for (const char* command :
       {"factors S", "solve S -o out", "plan S", "check S", "check S --fix fixed.json --within 1",
        "visibility S --at 1,1", "compare S --methods exact,center -o out", "reference out S", "view S --screenshot a.png"})
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
  for (const char* ending : {"stl", "ply", "off", "vs3"}) {
    const Outcome unread = place.run(std::string("hottel plan a.") + ending);
    EXPECT_EQ(unread.code, 3);
    EXPECT_THAT(unread.err,
                StartsWith(std::string("a.") + ending + ": files that end in ." + ending + " are not read"));
  }
}

}  // namespace
}  // namespace hottel
