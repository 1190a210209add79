// The program `hottel view` on a screen, from its start to its end.
#include "tests/window/view_program.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace hottel::view_program_test {
namespace {

using testing::HasSubstr;
using testing_cli::Workplace;
using testing_window::comes_true;
using testing_window::ViewProgram;
using testing_window::XvfbSession;

// A room with a wall upright in its middle, where the middle of the window is at any scale: pixels (640, 300) to
// (640, 450) are on it. A lamp is at its left.
constexpr const char* kRoom = R"({
  "hottel": 1, "dimension": 2,
  "materials": {"wall": {"reflectivity": 0.5}, "lamp": {"emission": 1}},
  "edges": [
    {"name": "west", "points": [[0, 0], [0, 4]], "material": "lamp"},
    {"name": "north", "points": [[0, 4], [8, 4]], "material": "wall"},
    {"name": "east", "points": [[8, 4], [8, 0]], "material": "wall"},
    {"name": "south", "points": [[8, 0], [0, 0]], "material": "wall"},
    {"name": "middle", "points": [[4, 1], [4, 3]], "material": "wall", "back": "wall"}
  ],
  "closed": true
})";

class ViewedProgram : public testing::Test {
 protected:
  ViewedProgram() {
    place_.write("room.json", kRoom);
    session_.xdotool("mousemove 1390 990");
  }

  ViewProgram view(std::vector<std::string> words = {"room.json"}) {
    return ViewProgram(session_, place_.path(""), words);
  }
  static bool gets_title(const ViewProgram& program, const std::string& title) {
    return comes_true([&] { return program.title() == title; });
  }
  static bool is_drawn(const Raster& frame) {
    return std::any_of(frame.pixels.begin(), frame.pixels.end(),
                       [&](std::uint32_t pixel) { return pixel != frame.pixels[0]; });
  }
  void expect_code(ViewProgram& program, int code) {
    EXPECT_EQ(program.exit_code(), std::optional(code)) << program.said();
  }

  Workplace place_;
  XvfbSession session_;
};

TEST_F(ViewedProgram, ADragIsSeenInTheTitleAndUndone) {
  ViewProgram program = view();
  EXPECT_TRUE(gets_title(program, "room.json - hottel"));
  const Raster before = program.frame_at_rest();
  EXPECT_TRUE(is_drawn(before));
  program.drag(640, 400, 700, 400);
  EXPECT_TRUE(gets_title(program, "room.json * - hottel"));
  const Raster after = program.frame_at_rest();
  EXPECT_FALSE(after == before);
  program.keys("ctrl+z");
  EXPECT_TRUE(gets_title(program, "room.json - hottel"));
  program.keys("ctrl+y");
  EXPECT_TRUE(gets_title(program, "room.json * - hottel"));
  program.keys("ctrl+z ctrl+q");
  expect_code(program, 0);
  EXPECT_EQ(place_.read("room.json"), kRoom);
}

TEST_F(ViewedProgram, AWalkThroughSpaceIsSeenAndAnEditOfLightIsInTheTitle) {
  place_.write("cube.json", R"({"hottel": 1, "dimension": 3,
    "materials": {"white": {"reflectivity": 0.5}, "lamp": {"emission": 1}}, "polygons": [
    {"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "white"},
    {"name": "ceiling", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "lamp"},
    {"name": "rear", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "white"},
    {"name": "left", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "white"}],
    "camera": {"eye": ["1/2", -2, "1/2"], "target": ["1/2", 1, "1/2"]}})");
  ViewProgram program = view({"cube.json"});
  EXPECT_TRUE(gets_title(program, "cube.json - hottel"));
  const Raster home = program.frame_at_rest();
  EXPECT_TRUE(is_drawn(home));
  program.keys("w w");
  EXPECT_TRUE(program.changes_from(home));
  const Raster nearer = program.frame_at_rest();
  program.drag(640, 400, 700, 380);
  EXPECT_TRUE(program.changes_from(nearer));
  program.keys("f");
  program.move(640, 400);
  program.frame_at_rest();
  program.keys("bracketright");
  EXPECT_TRUE(gets_title(program, "cube.json * - hottel"));
  program.keys("ctrl+z");
  EXPECT_TRUE(gets_title(program, "cube.json - hottel"));
  program.keys("ctrl+q");
  expect_code(program, 0);
}

// A spot in the middle of the window, which shines down to the right.
constexpr const char* kLitStage = R"({"hottel": 1, "dimension": 3, "materials": {"white": {"reflectivity": 0.5}},
    "polygons": [
    {"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "white", "elements": 6},
    {"name": "rear", "points": [[0,1,0],[1,1,0],[1,1,1],[0,1,1]], "material": "white", "elements": 6}],
    "lights": [{"type": "spot", "name": "torch", "position": [0.5, 0.5, 0.5], "direction": [1, 0, -1], "focus": 30,
                "power": 1}],
    "camera": {"eye": [0.5, -2, 0.5], "target": [0.5, 1, 0.5]}})";

TEST_F(ViewedProgram, ALightInSpaceIsDraggedAsAScriptDragsItAndSpins) {
  place_.write("stage.json", kLitStage);
  place_.write("drag.txt", "drag @640,400 @700,430\nkey ctrl+s\n");
  EXPECT_EQ(place_.run("cp stage.json scripted.json; hottel view scripted.json --script drag.txt").code, 0);
  ViewProgram program = view({"stage.json"});
  const Raster before = program.frame_at_rest();
  program.drag(640, 400, 700, 430);
  EXPECT_TRUE(gets_title(program, "stage.json * - hottel"));
  EXPECT_TRUE(program.changes_from(before));
  program.keys("ctrl+s");
  EXPECT_TRUE(gets_title(program, "stage.json - hottel"));
  EXPECT_NE(place_.read("stage.json"), kLitStage);
  EXPECT_EQ(place_.read("stage.json"), place_.read("scripted.json"));
  program.keys("r y");
  EXPECT_TRUE(gets_title(program, "stage.json * - hottel"));
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(program.changes_from(program.frame()));
  program.keys("Tab ctrl+z ctrl+z");
  EXPECT_TRUE(gets_title(program, "stage.json - hottel"));
  program.keys("ctrl+q");
  expect_code(program, 0);
}

TEST_F(ViewedProgram, APolygonInSpaceIsDraggedAsAScriptDragsIt) {
  place_.write("stage.json", kLitStage);
  place_.write("drag.txt", "click @640,650\ndrag @640,650 @640,620\nkey ctrl+s\n");
  EXPECT_EQ(place_.run("cp stage.json scripted.json; hottel view scripted.json --script drag.txt").code, 0);
  ViewProgram program = view({"stage.json"});
  program.frame_at_rest();
  program.drag(640, 650, 640, 650);  // a click
  const Raster picked = program.frame_at_rest();
  program.drag(640, 650, 640, 620);
  EXPECT_TRUE(gets_title(program, "stage.json * - hottel"));
  EXPECT_TRUE(program.changes_from(picked));
  program.keys("ctrl+s");
  EXPECT_TRUE(gets_title(program, "stage.json - hottel"));
  EXPECT_NE(place_.read("stage.json"), kLitStage);
  EXPECT_EQ(place_.read("stage.json"), place_.read("scripted.json"));
  program.keys("Delete");
  EXPECT_TRUE(gets_title(program, "stage.json * - hottel"));
  program.keys("ctrl+z");
  EXPECT_TRUE(gets_title(program, "stage.json - hottel"));
  program.keys("ctrl+q");
  expect_code(program, 0);
}

TEST_F(ViewedProgram, GathersLightInSpaceAtRest) {
  place_.write("stage.json", kLitStage);
  place_.write("gather.txt", "do gather\npicture gathered.png\n");
  EXPECT_EQ(place_.run("hottel view stage.json --script gather.txt").code, 0);
  ViewProgram program = view({"stage.json"});
  const auto is_saved_as_gathered = [&] {
    program.frame_at_rest();
    program.keys("ctrl+p Return");
    program.frame_at_rest();
    return place_.run("cmp stage.png gathered.png").code == 0;
  };
  EXPECT_TRUE(comes_true(is_saved_as_gathered, 10 * testing_window::kPatience));
  program.keys("ctrl+q");
  expect_code(program, 0);
}

TEST_F(ViewedProgram, WhatIsSavedIsWhatAScriptSavesAndSolvesAlike) {
  place_.write("drag.txt", "drag @640,400 @700,430\nkey ctrl+s\n");
  EXPECT_EQ(place_.run("cp room.json scripted.json; hottel view scripted.json --script drag.txt").code, 0);
  ViewProgram program = view();
  program.frame_at_rest();
  program.drag(640, 400, 700, 430);
  EXPECT_TRUE(gets_title(program, "room.json * - hottel"));
  program.keys("ctrl+s");
  EXPECT_TRUE(gets_title(program, "room.json - hottel"));
  EXPECT_NE(place_.read("room.json"), kRoom);
  EXPECT_EQ(place_.read("room.json"), place_.read("scripted.json"));
  for (const std::string name : {"room", "scripted"})
    EXPECT_EQ(place_.run("hottel solve " + name + ".json -o " + name + " --quiet").code, 0);
  const auto same = place_.run(
      "cmp room/radiosity.csv scripted/radiosity.csv && cmp room/illumination.npy "
      "scripted/illumination.npy");
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  program.keys("ctrl+q");
  expect_code(program, 0);
}

TEST_F(ViewedProgram, AsksWhereTheFileIsChangedByOthersAndReadsIt) {
  ViewProgram program = view();
  const Raster before = program.frame_at_rest();
  std::string other = kRoom;
  other.replace(other.find("[4, 1]"), 6, "[6, 1]");
  place_.write("room.json", other + "\n");
  ASSERT_TRUE(program.changes_from(before));  // it asks
  const Raster asking = program.frame_at_rest();
  program.keys("r");
  ASSERT_TRUE(program.changes_from(asking));
  EXPECT_FALSE(program.frame_at_rest() == before);
  EXPECT_TRUE(gets_title(program, "room.json - hottel"));
  program.keys("ctrl+s ctrl+q");
  expect_code(program, 0);
  EXPECT_THAT(place_.read("room.json"), HasSubstr("[6, 1]"));
}

TEST_F(ViewedProgram, TakesCoordinatesThatAreTyped) {
  ViewProgram program = view();
  program.frame_at_rest();
  program.move(640, 400);
  session_.xdotool("click 1");
  program.keys("Return ctrl+u");
  program.type("5, 1/2");
  program.keys("Return");
  EXPECT_TRUE(gets_title(program, "room.json * - hottel"));
  program.keys("ctrl+s");
  EXPECT_TRUE(gets_title(program, "room.json - hottel"));
  EXPECT_THAT(place_.read("room.json"), HasSubstr("[[5, 0.5], [5, 2.5]]"));
}

TEST_F(ViewedProgram, SavesUnderAnotherName) {
  ViewProgram program = view();
  program.frame_at_rest();
  program.drag(640, 400, 700, 400);
  EXPECT_TRUE(gets_title(program, "room.json * - hottel"));
  program.keys("ctrl+shift+s ctrl+u");
  program.type("no/such/folder.json");
  program.keys("Return ctrl+u");  // it says that this is none, and asks again
  program.type("other.json");
  program.keys("Return");
  EXPECT_TRUE(gets_title(program, "other.json - hottel"));
  EXPECT_EQ(place_.read("room.json"), kRoom);
  EXPECT_NE(place_.read("other.json"), kRoom);
  EXPECT_EQ(place_.run("hottel check other.json --quiet").code, 0);
  program.close();
  expect_code(program, 0);
}

TEST_F(ViewedProgram, ClosingAsksWhereChangesAreUnsaved) {
  ViewProgram program = view();
  program.frame_at_rest();
  program.drag(640, 400, 700, 400);
  EXPECT_TRUE(gets_title(program, "room.json * - hottel"));
  for (const std::string answer : {"Escape", "d"}) {
    const Raster before = program.frame_at_rest();
    program.close();
    ASSERT_TRUE(program.changes_from(before));
    const Raster asking = program.frame_at_rest();
    EXPECT_FALSE(program.has_ended());
    program.keys(answer);
    EXPECT_TRUE(answer == "d" || program.changes_from(asking));
  }
  expect_code(program, 0);
  EXPECT_EQ(place_.read("room.json"), kRoom);
}

TEST_F(ViewedProgram, IsInterrupted) {
  ViewProgram program = view();
  program.frame_at_rest();
  program.send(SIGINT);
  expect_code(program, 130);
}

TEST_F(ViewedProgram, EveryLookShowsSomethingElse) {
  ViewProgram program = view();
  program.move(500, 300);
  Raster before = program.frame_at_rest();
  for (const char* key : {"2", "3", "4", "5", "6", "7", "8", "9", "1", "h"}) {
    program.keys(key);
    EXPECT_TRUE(program.changes_from(before)) << key;
    before = program.frame_at_rest();
  }
  program.keys("h");
  EXPECT_TRUE(program.changes_from(before));
  before = program.frame_at_rest();
  program.keys("0");
  EXPECT_TRUE(program.changes_from(before));
}

TEST_F(ViewedProgram, ResizesAndZooms) {
  ViewProgram program = view();
  program.frame_at_rest();
  session_.xdotool("windowsize --sync " + program.id() + " 700 500");
  EXPECT_TRUE(comes_true([&] { return program.frame().width == 700 && program.frame().height == 500; }));
  const Raster small = program.frame_at_rest();
  EXPECT_TRUE(is_drawn(small));
  program.move(200, 250);
  const Raster before = program.frame_at_rest();
  session_.xdotool("click 4");
  EXPECT_TRUE(program.changes_from(before));
  program.frame_at_rest();
  session_.xdotool("click 5");
  EXPECT_TRUE(comes_true([&] { return program.frame() == before; }));
}

TEST_F(ViewedProgram, EndsCleanlyAtAnyMoment) {
  ASSERT_EQ(place_.run("hottel generate clutter --n 2000 -o big.json --quiet").code, 0);
  std::mt19937 random(20);
  for (int k = 0; k < 20; ++k) {
    ViewProgram program = view({"big.json"});
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 700));
    const bool by_signal = k % 4 == 3;
    by_signal ? program.send(SIGINT) : program.close();
    expect_code(program, by_signal ? 130 : 0);
    EXPECT_EQ(program.said(), "");
  }
}

TEST_F(ViewedProgram, AnswersWhileALargeSceneIsComputed) {
  // Large: its light takes many times as long as answers do on a machine that does much else.
  ASSERT_EQ(place_.run("hottel generate clutter --n 40000 -o large.json --quiet").code, 0);
  ViewProgram program = view({"large.json"});
  for (int k = 0; k < 4; ++k) {
    const Raster before = program.frame();
    program.keys("h");
    ASSERT_TRUE(program.changes_from(before));
  }
  const Raster answered = program.frame();  // nothing is touched after it: what comes is light
  EXPECT_TRUE(program.changes_from(answered, 10 * testing_window::kPatience));
}

}  // namespace
}  // namespace hottel::view_program_test
