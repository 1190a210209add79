// Several grids of a scene in the plane: each has the files that it has alone, in all that commands do with grids.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::testing_cli::plane_grids_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::string kRoom = R"("min": [0, 0], "max": [4, 3], "cells": [8, 6]})";
const std::string kDesk = R"("min": [1, "1/3"], "max": [2, 1], "cells": [4, 3]})";
const std::string kBoth = "[{\"name\": \"room\", " + kRoom + ",\n{\"name\": \"desk\", " + kDesk + "]";

// A warm room with a lamp in it, and one grid or a list of some.
std::string with_grid(const std::string& grid) {
  return R"({"hottel": 1, "dimension": 2,
  "materials": {"white": {"emissivity": 0.3, "temperature": 300}, "lamp": {"emissivity": 0.9, "temperature": 900}},
  "polylines": [{"name": "walls", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "white"},
                {"name": "lamp", "points": [[1,1],[2,1],[2,2],[1,2]], "closed": true, "material": "lamp"}],
  "grid": )" +
         grid + "}";
}

// both.json, and each of its grids alone: room.json, desk.json.
class PlaneGrids : public testing::Test {
 protected:
  PlaneGrids() {
    place.write("both.json", with_grid(kBoth));
    place.write("room.json", with_grid("{" + kRoom));
    place.write("desk.json", with_grid("{" + kDesk));
  }
  // Solves all three; KIND.ENDING of each grid alone is KIND-NAME.ENDING of the list.
  void expect_each_as_alone(const std::string& options, const std::vector<std::string>& files) const {
    const Outcome both = place.run("hottel solve both.json -o both " + options);
    ASSERT_EQ(both.code, 0) << both.err;
    for (const std::string name : {"room", "desk"}) {
      const Outcome alone = place.run("hottel solve " + name + ".json -o " + name + " " + options);
      ASSERT_EQ(alone.code, 0) << alone.err;
      for (const std::string& file : files) {
        const auto dot = file.find('.');
        const std::string one = place.read(name + "/" + file);
        EXPECT_FALSE(one.empty()) << file;
        EXPECT_EQ(place.read("both/" + file.substr(0, dot) + "-" + name + file.substr(dot)), one)
            << options << ": " << file << " of " << name;
      }
    }
  }

  Workplace place;
};

TEST_F(PlaneGrids, HaveTheNumbersAndPicturesThatEachHasAlone) {
  for (const std::string way : {"point", "average", "inverse-square"})
    expect_each_as_alone("--contours 4 --axes --size 300 --illumination " + way,
                         {"illumination.npy", "illumination.png"});
  EXPECT_THAT(place.files(), Not(Contains("both/illumination.npy")));
}

TEST_F(PlaneGrids, HaveWhatIsShownAtPoints) {
  for (const std::string what : {"temperature", "irradiance", "sky"})
    expect_each_as_alone("--show " + what, {"illumination.npy", "shown.npy", "illumination.png"});
}

TEST_F(PlaneGrids, AreDividedByTheOptionEach) {
  expect_each_as_alone("--grid 5x7", {"illumination.npy", "illumination.png"});
  EXPECT_THAT(place.read("both/illumination-desk.npy"), HasSubstr("'shape': (7, 5, 1)"));
}

TEST_F(PlaneGrids, HaveThePlaceOfEachBesideItsNumbers) {
  ASSERT_EQ(place
                .run("hottel solve both.json -o both --show temperature && hottel solve desk.json -o desk "
                     "--show temperature")
                .code,
            0);
  for (const std::string kind : {"illumination", "shown"}) {
    auto named = nlohmann::json::parse(place.read("both/" + kind + "-desk.npy.json"));
    EXPECT_EQ(named["grid"], "desk");
    named.erase("grid");
    EXPECT_EQ(named, nlohmann::json::parse(place.read("desk/" + kind + ".npy.json")));
  }
}

TEST_F(PlaneGrids, GiveTheirNamesToFilesOfTheCommandLine) {
  expect_each_as_alone("--views seen.mtx --render drawn.svg", {});
  for (const std::string name : {"room", "desk"}) {
    ASSERT_EQ(place.run("hottel solve " + name + ".json -o one --views one.mtx --render one.svg").code, 0);
    EXPECT_EQ(place.read("seen-" + name + ".mtx"), place.read("one.mtx"));
    EXPECT_EQ(place.read("seen-" + name + ".mtx.faces.csv"), place.read("one.mtx.faces.csv"));
    EXPECT_EQ(place.read("drawn-" + name + ".svg"), place.read("one.svg"));
  }
  const Outcome said = place.run("mkdir in.d; hottel solve both.json -o both --views in.d/v.mtx --render in.d/p.png");
  EXPECT_THAT(said.err, HasSubstr("what the cells see: in.d/v-room.mtx, in.d/v-desk.mtx\n"));
  EXPECT_THAT(said.err, HasSubstr("the picture: in.d/p-room.png, in.d/p-desk.png"));
}

TEST_F(PlaneGrids, HaveOnePictureOfWhatFacesAloneShow) {
  ASSERT_EQ(place
                .run("hottel solve both.json -o both --show radiosity --render p.svg && "
                     "hottel solve desk.json -o desk --show radiosity")
                .code,
            0);
  EXPECT_EQ(place.read("both/illumination.png"), place.read("desk/illumination.png"));
  EXPECT_THAT(place.files(), Contains("p.svg"));
  EXPECT_EQ(place.read("both/illumination-desk.npy"), place.read("desk/illumination.npy"));
  const Outcome dark = place.run("hottel solve both.json -o dark --no-illumination; ls dark");
  EXPECT_THAT(dark.out, Not(HasSubstr("illumination")));
}

TEST_F(PlaneGrids, AreToldOfInTheReport) {
  for (const std::string options : {"--contours 3", "--show temperature"}) {
    ASSERT_EQ(
        place.run("hottel solve both.json -o both " + options + " && hottel solve desk.json -o desk " + options).code,
        0);
    const auto both = nlohmann::json::parse(place.read("both/report.json"));
    EXPECT_FALSE(both.contains("picture"));
    ASSERT_EQ(both["pictures"].size(), 2u);
    EXPECT_EQ(both["pictures"][0]["grid"], "room");
    auto desk = both["pictures"][1];
    EXPECT_EQ(desk["grid"], "desk");
    desk.erase("grid");
    EXPECT_EQ(desk, nlohmann::json::parse(place.read("desk/report.json"))["picture"]);
  }
  const auto bound = [&](const std::string& name) {
    EXPECT_EQ(place.run("hottel solve " + name + ".json -o " + name + " --illumination average").code, 0);
    return nlohmann::json::parse(place.read(name + "/report.json"))["bounds"]["illumination_max_error"].get<double>();
  };
  EXPECT_EQ(bound("both"), std::max(bound("room"), bound("desk")));
}

TEST_F(PlaneGrids, OfAnEarlierRunAreNamed) {
  ASSERT_EQ(place.run("hottel solve both.json -o out").code, 0);
  const Outcome less = place.run("hottel solve desk.json -o out");
  EXPECT_THAT(less.err,
              HasSubstr("of an earlier run, and left as it was: illumination-desk.npy illumination-room.npy"));
}

TEST_F(PlaneGrids, AreAllPlanned) {
  EXPECT_THAT(place.run("hottel plan both.json").out, HasSubstr("60 cells"));
  EXPECT_THAT(place.run("hottel plan both.json --grid 5x2").out, HasSubstr("20 cells"));
  EXPECT_THAT(place.run("hottel solve both.json -o out").err, HasSubstr("60 cells"));
}

TEST_F(PlaneGrids, AreComparedByTheNamesOfFiles) {
  ASSERT_EQ(place.run("hottel solve both.json -o both").code, 0);
  const std::string compare = "hottel compare both.json --repeat 1 -o judged --grid-file ";
  for (const std::string name : {"room", "desk"}) {
    const Outcome judged = place.run(compare + "both/illumination-" + name + ".npy");
    EXPECT_EQ(judged.code, 0) << judged.err;
    EXPECT_THAT(place.read("judged/grid.csv"), HasSubstr(name == "room" ? "all,44,0,0,0,0," : "all,12,0,0,0,0,"));
  }
  const Outcome unknown = place.run("cp both/illumination-desk.npy x.npy; " + compare + "x.npy");
  EXPECT_EQ(unknown.code, 3);
  EXPECT_THAT(unknown.err,
              HasSubstr("x.npy: is light on one of several grids, and its name does not say which: 'room', 'desk'"));
  const Outcome other = place.run("cp both/illumination-desk.npy x-room.npy; " + compare + "x-room.npy");
  EXPECT_THAT(other.err, HasSubstr("has the shape (3, 4), and the grid of the scene (6, 8)"));
}

TEST_F(PlaneGrids, WhoseNamesEndAlikeAreComparedByTheLongest) {
  place.write("alike.json", with_grid("[{\"name\": \"desk\", " + kDesk + ", {\"name\": \"old-desk\", " + kRoom + "]"));
  const Outcome judged = place.run(
      "hottel solve alike.json -o out && hottel compare alike.json --repeat 1 -o judged --grid-file "
      "out/illumination-old-desk.npy");
  EXPECT_EQ(judged.code, 0) << judged.err;
}

TEST_F(PlaneGrids, AreReferredToEach) {
  const Outcome outcome = place.run("hottel reference set both.json --quiet && hottel solve both.json -o both");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const std::string name : {"room", "desk"})
    EXPECT_EQ(place.read("set/both/illumination-" + name + ".npy"), place.read("both/illumination-" + name + ".npy"));
  const Outcome again = place.run(
      "hottel reference finer both.json --grid 3x2 --quiet && "
      "hottel plan finer/both/scene.json");
  EXPECT_THAT(again.out, HasSubstr("12 cells"));
}

TEST_F(PlaneGrids, AreKeptByConversions) {
  const Outcome outcome = place.run(
      "hottel convert both.json both.hs && hottel convert both.hs again.json && hottel convert again.json twice.json "
      "&& "
      "cmp again.json twice.json && hottel solve both.hs -o bytes && hottel solve again.json -o text && "
      "cmp bytes/illumination-desk.npy text/illumination-desk.npy");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(place.read("again.json"), HasSubstr(R"("grid": [
    {"name": "room", "min": [0, 0], "max": [4, 3], "cells": [8, 6]},
    {"name": "desk", "min": [1, "1/3"], "max": [2, 1], "cells": [4, 3]}
  ])"));
}

TEST_F(PlaneGrids, AreRefusedWithFileAndLine) {
  const auto said = [&](const std::string& grid) {
    place.write("bad.json", with_grid(grid));
    const Outcome outcome = place.run("hottel check bad.json");
    EXPECT_EQ(outcome.code, 3);
    return outcome.err;
  };
  const std::string named = "[{\"name\": \"desk\", " + kDesk + ",\n";
  EXPECT_THAT(said(named + "{\"name\": \"desk\", " + kRoom + "]"),
              HasSubstr("bad.json:6: grid: two are called 'desk'"));
  EXPECT_THAT(said(named + "{" + kRoom + "]"), HasSubstr("bad.json:6: grid has no \"name\""));
  EXPECT_THAT(said("[{" + kRoom + "]"), HasSubstr("bad.json:5: grid has no \"name\""));
  EXPECT_THAT(said("[]"), HasSubstr("bad.json:5: grid: the list is empty"));
  EXPECT_THAT(said(named + "{\"name\": \"a/b\", " + kRoom + "]"),
              HasSubstr("bad.json:6: grid: a name must not contain"));
  EXPECT_THAT(said("{\"name\": \"desk\", " + kDesk), HasSubstr("bad.json:5: grid has the unknown key 'name'"));
}

TEST_F(PlaneGrids, TheFirstIsAnimatedAndShownInTheWindow) {
  const Outcome frames = place.run(
      "hottel animate both.json --frames 1 -o both && hottel animate room.json --frames 1 -o room && "
      "cmp both/frame_00000.png room/frame_00000.png");
  EXPECT_EQ(frames.code, 0) << frames.out << frames.err;
}

TEST_F(PlaneGrids, StayInTheSceneThatTheWindowSaves) {
  place.write("steps.txt", "drag 1,1.5 0.5,1.5 ctrl\nsave saved.json\nhash\n");
  const Outcome outcome = place.run(
      "hottel view both.json --script steps.txt && hottel solve saved.json -o out && sha256sum < "
      "out/illumination-room.npy");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("saved.json"), HasSubstr("{\"name\": \"desk\", \"min\": [1, \"1/3\"]"));
  EXPECT_NE(place.read("saved.json").find("0.5"), std::string::npos) << "the lamp moved";
  const std::string sum = lines_of(outcome.out).back().substr(0, 64);
  EXPECT_THAT(outcome.out, HasSubstr("illumination-room.npy " + sum));
}

}  // namespace
}  // namespace hottel::testing_cli::plane_grids_test
