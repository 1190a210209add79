// hottel view without a screen: scripts, pictures, recordings, and what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace hottel::view_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

class View : public testing::Test {
 protected:
  View() {
    place.write("room.json", R"({"hottel": 1, "dimension": 2, "materials": {"white": {"reflectivity": 0.7},
      "lamp": {"emission": 3}}, "grid": {"min": [0, 0], "max": [4, 3], "cells": [8, 6]},
      "polylines": [{"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "white"},
                    {"name": "lamp", "points": [[1,1],[2,1],[2,2],[1,2]], "closed": true, "material": "lamp"}]})");
  }
  Outcome view(const std::string& options) const { return place.run("hottel view " + options); }
  Outcome play(const std::string& script, const std::string& options = "") const {
    place.write("steps.txt", script);
    return view("room.json --script steps.txt " + options);
  }
  Workplace place;
};

TEST_F(View, BadScriptsAreFileErrorsThatNameTheLine) {
  for (const auto& [script, where] :
       {std::pair("hash\n\njump 1,2\n", "steps.txt:3: "), std::pair("move here\n", "steps.txt:1: "),
        std::pair("#\ndo nothing\n", "steps.txt:2: "), std::pair("picture x.gif\n", "steps.txt:1: ")}) {
    const Outcome outcome = play(script);
    EXPECT_EQ(outcome.code, 3) << script;
    EXPECT_THAT(outcome.err, StartsWith(where)) << script;
  }
  // A script is read as a whole before it begins.
  EXPECT_EQ(play("hash\njump\n").out, "");
  const Outcome piped = place.run("echo jump | hottel view room.json --script -");
  EXPECT_EQ(piped.code, 3);
  EXPECT_THAT(piped.err, StartsWith("standard input:1: "));
}

TEST_F(View, FilesThatAreMissingAreFileErrors) {
  for (const char* options : {"none.json --screenshot x.png", "room.json --script none.txt"}) {
    const Outcome outcome = view(options);
    EXPECT_EQ(outcome.code, 3) << options;
    EXPECT_THAT(outcome.err, HasSubstr("none.")) << options;
  }
  place.write("bad.json", "{\n\"hottel\": 1,\n}");
  EXPECT_EQ(view("bad.json --screenshot x.png").code, 3);
  const Outcome unwritable = play("screenshot no/such/folder.png\n");
  EXPECT_EQ(unwritable.code, 3);
  EXPECT_THAT(unwritable.err, HasSubstr("no/such/folder.png"));
  EXPECT_EQ(view("room.json --screenshot no/such/folder.png").code, 3);
}

TEST_F(View, UnknownLooksAreUsageErrorsWithNearNames) {
  const Outcome outcome = view("room.json --look bends --screenshot x.png");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("hottel: there is nothing to look at called 'bends'"));
  EXPECT_THAT(outcome.err, HasSubstr("bands"));
  EXPECT_THAT(place.files(), testing::Not(testing::Contains("x.png")));
}

TEST_F(View, WithoutADisplaySaysWhatNeedsNone) {
  const Outcome outcome = place.run("env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER hottel view room.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("display"));
  for (const char* option : {"--screenshot", "--script", "--record"}) EXPECT_THAT(outcome.err, HasSubstr(option));
}

TEST_F(View, WithoutSdlSaysWhatNeedsNoneAndOtherCommandsWork) {
  place.write("libSDL2-2.0.so.0", "");
  const std::string without = "env LD_LIBRARY_PATH=. hottel ";
  const Outcome outcome = place.run(without + "view room.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  for (const char* part : {"libSDL2-2.0.so.0", "libsdl2-2.0-0", "--screenshot", "--script", "--record"})
    EXPECT_THAT(outcome.err, HasSubstr(part));
  EXPECT_EQ(place.run(without + "view room.json --screenshot x.png").code, 0);
}

// The bytes of a new process on the saved scene.
TEST_F(View, HashesAreThoseOfAFreshProcess) {
  const Outcome outcome = play("drag 1.5,1 1.8,0.8 ctrl\nmove 2,2.95\nkey ]\nhash\nsave moved.json\n");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Outcome fresh = place.run(
      "hottel factors moved.json --quiet > factors.csv; hottel solve moved.json --quiet -o out; "
      "for f in factors.csv out/radiosity.csv out/illumination.npy; do sha256sum $f | cut -c1-64; done");
  ASSERT_EQ(fresh.code, 0) << fresh.err;
  const auto sums = lines_of(fresh.out);
  ASSERT_EQ(sums.size(), 3u);
  EXPECT_EQ(outcome.out,
            "factors.csv " + sums[0] + " radiosity.csv " + sums[1] + " illumination.npy " + sums[2] + "\n");
}

TEST_F(View, AScriptOfStandardInputDoesTheSame) {
  const std::string script = "drag 1.5,1 1.8,0.8 ctrl\nhash\n";
  const Outcome file = play(script), piped = place.run("hottel view room.json --script - < steps.txt");
  EXPECT_EQ(piped.out, file.out);
  EXPECT_NE(file.out, "");
  EXPECT_EQ(play(script, "--scale 1 --look plan").out, file.out);
}

TEST_F(View, ChangesNoFileUnlessToldTo) {
  const std::string before = place.read("room.json");
  EXPECT_EQ(play("drag 1.5,1 1.8,0.8 ctrl\nclose\n").code, 0);
  EXPECT_EQ(place.read("room.json"), before);
  EXPECT_EQ(play("drag 1.5,1 1.8,0.8 ctrl\nclose\nkey s\njump no more\n").code, 3);
  EXPECT_EQ(play("drag 1.5,1 1.8,0.8 ctrl\nclose\nkey s\nsave never.json\n").code, 0);
  EXPECT_NE(place.read("room.json"), before);
  EXPECT_THAT(place.files(), ElementsAre("room.json", "steps.txt"));
}

TEST_F(View, RecordsNumberedFrames) {
  const Outcome outcome = play("key h\nkey h\npause 0.1\n", "--record frames --size 200x150");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("5 frames, 20 a second, in frames"));
  EXPECT_EQ(place.run("ls frames").out,
            "frame-00001.png\nframe-00002.png\nframe-00003.png\nframe-00004.png\nframe-00005.png\n");
  EXPECT_THAT(place.read("frames/frame-00001.png"), StartsWith("\x89PNG"));
}

TEST_F(View, SaysWhatIsWrongWithoutLightAndGoesOn) {
  place.write("dark.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}, "n": {}},
    "edges": [{"name": "one", "points": [[0,0],[2,0]], "material": "m"},
              {"name": "two", "points": [[1,0],[3,0]], "material": "n"}]})");
  const Outcome outcome = place.run("echo hash | hottel view dark.json --script - --screenshot dark.png");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "factors.csv - radiosity.csv - illumination.npy -\n");
  EXPECT_THAT(place.read("dark.png"), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace hottel::view_test
