// hottel animate as users meet it: frames, one file of them, going on where a run ended, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::animate_test {
namespace {

using testing::HasSubstr;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string room(const std::string& lights) {
  return R"({ "hottel": 1, "dimension": 2, "materials": {"grey": {"reflectivity": [0.5, 0.4, 0.3]}},
  "polylines": [{"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "grey"},
                {"name": "post", "points": [[2,1],["2.5",1],["2.5","1.5"],[2,"1.5"]], "closed": true, "material": "grey"}],
  "grid": {"min": [0,0], "max": [4,3], "cells": [16,12]},
  "lights": [)" +
         lights + "] }";
}

const std::string kSpot = R"({"type": "spot", "name": "torch", "position": [1,1], "direction": [1,0], "focus": 20,
  "power": 3, "rotation": 90})";

// The numbers of each line: all but the sum at its end.
std::vector<std::vector<double>> frames_of(const std::string& csv) {
  std::vector<std::vector<double>> result;
  for (const std::string& line : lines_of(csv)) {
    if (line.starts_with("frame")) continue;
    std::istringstream cells(line);
    std::vector<double>& row = result.emplace_back();
    for (std::string cell; row.size() < 9 && std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  }
  return result;
}

TEST(Animate, WritesFramesOneFileOfThemAndWhatTheyTook) {
  const Workplace place;
  place.write("scene.json", room(kSpot));
  const Outcome outcome = place.run("hottel animate scene.json --frames 12 --fps 2 --light-levels 3 -o film");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("12 frames"));
  const auto frames = frames_of(place.read("film/frames.csv"));
  ASSERT_EQ(frames.size(), 12u);
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_EQ(frames[k][0], static_cast<double>(k));
    EXPECT_EQ(frames[k][1], static_cast<double>(k) / 2);
    // Once around in four seconds: then nothing is computed.
    EXPECT_EQ(frames[k][4] == 0, k >= 8 || frames[k][5] > 0) << k;
    EXPECT_EQ(frames[k][2], frames[k >= 8 ? k - 8 : k][2]);
    const std::string name = "film/frame_0000" + std::to_string(k) + ".png";
    if (k < 4) {
      const std::string later =
          "film/frame_" + std::string(k + 8 < 10 ? "0000" : "000") + std::to_string(k + 8) + ".png";
      EXPECT_EQ(place.read(name), place.read(later)) << "the light is back";
      EXPECT_NE(place.read(name), place.read("film/frame_00004.png"));
    }
  }
  EXPECT_THAT(place.read("film/animation.png"), HasSubstr("acTL"));
  const auto json = nlohmann::json::parse(place.read("film/animation.json"));
  EXPECT_EQ(json.at("frames"), 12);
  EXPECT_EQ(json.at("frames_per_second"), 2);
}

TEST(Animate, TheFirstFrameHasTheLightOfSolve) {
  const Workplace place;
  place.write("scene.json", room(kSpot));
  EXPECT_EQ(place.run("hottel animate scene.json --frames 1 --light-levels 3 -o film --no-film").code, 0);
  EXPECT_EQ(place.run("hottel solve scene.json --light-levels 3 -o solved").code, 0);
  EXPECT_EQ(place.read("film/frame_00000.png"), place.read("solved/illumination.png"));
  EXPECT_FALSE(testing_cli::fs::exists(place.path("film/animation.png")));
}

TEST(Animate, GoesOnWhereARunEndedAndMakesTheSameFrames) {
  const Workplace place;
  place.write("scene.json", room(kSpot));
  const std::string line = "hottel animate scene.json --frames 6 --fps 3 --light-levels 3 -o ";
  EXPECT_EQ(place.run(line + "whole").code, 0);
  // Killed at any time: what is there is whole, and the rest follows.
  for (const char* seconds : {"0.02", "0.05", "0.1", "0.15", "0.2"}) {
    place.run("timeout -s KILL " + std::string(seconds) + " " + line + "parts");
    for (const auto& row : frames_of(
             testing_cli::fs::exists(place.path("parts/frames.csv")) ? place.read("parts/frames.csv") : std::string()))
      EXPECT_EQ(row.size(), 9u);
  }
  EXPECT_EQ(place.run(line + "parts").code, 0);
  for (int k = 0; k < 6; ++k) {
    const std::string name = "/frame_0000" + std::to_string(k) + ".png";
    EXPECT_EQ(place.read("parts" + name), place.read("whole" + name)) << k;
  }
  EXPECT_EQ(place.read("parts/animation.png"), place.read("whole/animation.png"));
  // Again: nothing is made; with one frame taken away, that one.
  const Outcome again = place.run(line + "whole");
  EXPECT_THAT(again.err, HasSubstr("6 of them there before"));
  testing_cli::fs::remove(place.path("whole/frame_00003.png"));
  EXPECT_THAT(place.run(line + "whole").err, HasSubstr("5 of them there before"));
  EXPECT_EQ(place.read("parts/frame_00003.png"), place.read("whole/frame_00003.png"));
  // Another scene, or other options: all are made anew.
  place.write("scene.json", room(kSpot).replace(room(kSpot).find("\"power\": 3"), 10, "\"power\": 4"));
  EXPECT_THAT(place.run(line + "whole").err, testing::Not(HasSubstr("there before")));
}

// All columns but computed to picture_seconds, and the sum: a function of the scene.
std::vector<std::vector<double>> told_of_frames(const std::string& csv) {
  std::vector<std::vector<double>> rows = frames_of(csv);
  for (auto& row : rows) row.erase(row.begin() + 4, row.begin() + 8);
  return rows;
}

TEST(Animate, TellsAfterARunThatWasEndedWhatItTellsWithoutThat) {
  const Workplace place;
  place.write("scene.json", room(kSpot));
  const std::string line = "hottel animate scene.json --frames 6 --fps 3 --light-levels 3 --no-film --quiet -o ";
  ASSERT_EQ(place.run(line + "whole").code, 0);
  const auto expected = told_of_frames(place.read("whole/frames.csv"));
  ASSERT_EQ(expected.size(), 6u);
  EXPECT_LT(expected[3][3], expected[3][2]) << "not all elements are new";
  for (const std::string missing : {"0", "1", "3", "5", "[0-2]", "[1-4]", "[025]"}) {
    ASSERT_EQ(place.run("rm -rf parts; cp -r whole parts; rm parts/frame_0000" + missing + ".png").code, 0);
    ASSERT_EQ(place.run(line + "parts").code, 0);
    EXPECT_EQ(told_of_frames(place.read("parts/frames.csv")), expected) << missing;
    for (int k = 0; k < 6; ++k) {
      const std::string name = "/frame_0000" + std::to_string(k) + ".png";
      EXPECT_EQ(place.read("parts" + name), place.read("whole" + name)) << missing << name;
    }
  }
}

TEST(Animate, MakesADamagedFrameAgain) {
  const Workplace place;
  place.write("scene.json", room(kSpot));
  const std::string line = "hottel animate scene.json --frames 4 --fps 2 --light-levels 2 --no-film -o ";
  ASSERT_EQ(place.run(line + "whole").code, 0);
  const struct {
    const char *damage, *were_there;
  } cases[] = {
      {"truncate -s -1 parts/frame_00001.png", "3 of them"},
      {"truncate -s 0 parts/frame_00001.png", "3 of them"},
      {"printf x | dd of=parts/frame_00002.png bs=1 seek=60 conv=notrunc", "3 of them"},
      {"cp parts/frame_00000.png parts/frame_00003.png", "3 of them"},  // a whole picture of another frame
      {"cp parts/frame_00000.png t; cp parts/frame_00001.png parts/frame_00000.png; mv t parts/frame_00001.png",
       "2 of them"},
      {"sed -i '3s/^1,0.5/1,0.25/' parts/frames.csv", "3 of them"},
      {"sed -i '4s/,[0-9]*,\\([0-9.e-]*,[0-9.e-]*,[0-9.e-]*,[0-9a-f]*\\)$/,9,\\1/' parts/frames.csv", "3 of them"},
      {"truncate -s -9 parts/frames.csv", "3 of them"},
      {"sed -i 3d parts/frames.csv", "3 of them"},
      {"truncate -s 100 parts/frames.csv", ""},
      {"truncate -s 0 parts/frames.csv", ""},
      {"rm parts/frames.csv", ""},
      {"truncate -s -20 parts/animation.json", ""},
      {"sed -i 's/\"key\": \"./\"key\": \"x/' parts/animation.json", ""},
  };
  for (const auto& [damage, were_there] : cases) {
    ASSERT_EQ(place.run("rm -rf parts; cp -r whole parts; " + std::string(damage)).code, 0) << damage;
    const Outcome outcome = place.run(line + "parts");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    if (*were_there == 0) {
      EXPECT_THAT(outcome.err, testing::Not(HasSubstr("of them"))) << damage;
    } else {
      EXPECT_THAT(outcome.err, HasSubstr(std::string(were_there) + " there before")) << damage;
    }
    EXPECT_EQ(told_of_frames(place.read("parts/frames.csv")), told_of_frames(place.read("whole/frames.csv"))) << damage;
    for (int k = 0; k < 4; ++k) {
      const std::string name = "/frame_0000" + std::to_string(k) + ".png";
      EXPECT_EQ(place.read("parts" + name), place.read("whole" + name)) << damage << name;
    }
    EXPECT_THAT(place.run(line + "parts").err, HasSubstr("4 of them there before")) << damage;
  }
}

TEST(Animate, RefusesLightsThatComeToLieOnSurfacesBeforeAnyFrame) {
  const Workplace place;
  place.write("scene.json", room(R"({"type": "point", "name": "lamp", "power": 1,
    "path": {"points": [[1,2],[3,0]], "seconds": 10}})"));
  const Outcome outcome = place.run("hottel animate scene.json --frames 20 --fps 1 -o film");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("scene.json"));
  EXPECT_THAT(outcome.err, HasSubstr("frame 5, at 5 s"));
  EXPECT_THAT(outcome.err, HasSubstr("lamp"));
  EXPECT_THAT(outcome.err, HasSubstr("post"));
  EXPECT_FALSE(testing_cli::fs::exists(place.path("film")));
}

// Rows are divided over the elements that are active in a frame, and their own sums are told.
TEST(Animate, TakesAnyMethodAndTellsTheDefectBeforeRowsAreDivided) {
  const Workplace place;
  place.write("scene.json", room(kSpot));
  const std::string line = "hottel animate scene.json --frames 3 --fps 1 --light-levels 2 --quiet --method ";
  ASSERT_EQ(place.run(line + "center -o raw").code, 0);
  ASSERT_EQ(place.run(line + "center:normalised -o normalised").code, 0);
  const auto last = [&](const std::string& folder) { return place.run("cut -d, -f9 " + folder + "/frames.csv").out; };
  EXPECT_EQ(last("raw"), last("normalised"));
  EXPECT_THAT(last("raw"), testing::Not(HasSubstr("\n0\n"))) << "centres are off";
  EXPECT_NE(place.read("raw/frame_00001.png"), place.read("normalised/frame_00001.png"));
  ASSERT_EQ(place.run(line + "exact -o raw").code, 0);
  EXPECT_EQ(last("raw"), "row_defect\n0\n0\n0\n") << "of another method they are made anew";
}

TEST(Animate, SaysThatNothingMoves) {
  const Workplace place;
  place.write("scene.json", room(R"({"type": "point", "name": "lamp", "position": [1,1], "power": 1})"));
  const Outcome outcome = place.run("hottel animate scene.json --frames 2 -o film");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("turns or follows a path"));
  EXPECT_EQ(place.read("film/frame_00000.png"), place.read("film/frame_00001.png"));
}

TEST(Animate, AStoreServesLaterRunsInSpace) {
  const Workplace place;
  place.write("scene.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
  {"name": "floor", "points": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], "material": "m"},
  {"name": "wall", "points": [[0, 2, 0], [2, 2, 0], [2, 2, 2], [0, 2, 2]], "material": "m"},
  {"name": "board", "points": [[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]], "material": "m", "back": "m"}],
  "camera": {"eye": [1, -3, 2], "target": [1, 1, 1], "up": [0, 0, 1], "field_of_view": 60, "pixels": [40, 30]},
  "lights": [{"type": "spot", "name": "l", "position": [1, "0.9", 1], "direction": [0, 0, -1], "focus": 25, "power": 1,
              "rotation": [45, 0, 0]}]})");
  const std::string line = "hottel animate scene.json --frames 3 --fps 1 --light-levels 2 --store s -o ";
  EXPECT_EQ(place.run(line + "first").code, 0);
  EXPECT_EQ(place.run(line + "second").code, 0);
  EXPECT_EQ(place.run("hottel animate scene.json --frames 3 --fps 1 --light-levels 2 -o without").code, 0);
  const auto first = frames_of(place.read("first/frames.csv")), second = frames_of(place.read("second/frames.csv"));
  double computed = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    computed += first[k][4];
    EXPECT_EQ(second[k][4], 0) << "all is in the store";
    EXPECT_EQ(second[k][2], first[k][2]);
    const std::string name = "/frame_0000" + std::to_string(k) + ".png";
    EXPECT_EQ(place.read("first" + name), place.read("second" + name));
    EXPECT_EQ(place.read("first" + name), place.read("without" + name));
  }
  EXPECT_GT(computed, 0);
}

}  // namespace
}  // namespace hottel::animate_test
