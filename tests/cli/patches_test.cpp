// Patches on the command line, in both dimensions: "on" and data-on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::patches_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing_cli::Outcome;
using testing_cli::table;
using testing_cli::Workplace;
using Json = nlohmann::json;

const std::string kPlane = R"({"hottel": 1, "dimension": 2,
  "materials": {"white": {"reflectivity": 0.5}, "day": {"emission": 5}},
  "edges": [{"name": "window", "points": [[0,1],[0,2]], "material": "day"ON}],
  "polylines": [{"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "white"}]})";

const std::string kSpace = R"({"hottel": 1, "dimension": 3,
  "materials": {"panel": {"emissivity": 0.9, "temperature": 300}, "cells": {"emissivity": 0.8, "temperature": 310}},
  "sky": {"temperature": 3},
  "polygons": [
    {"name": "panel", "points": [[0,0,0],[2,0,0],[2,1,0],[0,1,0]], "material": "panel", "back": "panel"},
    {"name": "cells", "points": [[0.2,0.2,0],[1.8,0.2,0],[1.8,0.8,0],[0.2,0.8,0]], "material": "cells"ON}]})";

std::string with(std::string text, const std::string& on) { return text.replace(text.find("ON"), 2, on); }

TEST(PatchesByHand, AreWhatTheMessageAboutConflictsOffers) {
  const Workplace place;
  place.write("plane.json", with(kPlane, ""));
  place.write("space.json", with(kSpace, ""));
  const Outcome plane = place.run("hottel factors plane.json"), space = place.run("hottel factors space.json");
  EXPECT_EQ(plane.code, 3);
  EXPECT_THAT(plane.err, AllOf(HasSubstr("plane.json:4: 'window' (front) and 'room[0]' (front) claim the same side"),
                               HasSubstr(R"("on": "room")")));
  EXPECT_EQ(space.code, 3);
  EXPECT_THAT(space.err, AllOf(HasSubstr("space.json:6: 'panel' (front) and 'cells' (front) claim the same side"),
                               HasSubstr(R"("on": "panel")")));
}

TEST(PatchesByHand, AreWhatTheCheckOffersToo) {
  const Workplace place;
  place.write("plane.json", with(kPlane, ""));
  place.write("space.json", with(kSpace, ""));
  EXPECT_THAT(place.run("hottel check plane.json").out, HasSubstr(R"("on": "room")"));
  EXPECT_THAT(place.run("hottel check space.json").out, HasSubstr(R"("on": "panel")"));
}

TEST(PatchesByHand, HaveRowsOfTheirOwn) {
  const Workplace place;
  place.write("plane.json", with(kPlane, R"(, "on": "room")"));
  place.write("space.json", with(kSpace, R"(, "on": "panel")"));
  const auto plane = table(place.run("hottel factors plane.json --areas --quiet").out, 2);
  EXPECT_EQ(plane.count("window,room[2]"), 1u);
  const Outcome solved = place.run("hottel solve space.json -o out --no-picture --quiet");
  ASSERT_EQ(solved.code, 0) << solved.err;
  const auto radiosity = table(place.read("out/radiosity.csv"), 1);
  EXPECT_EQ(radiosity.at("panel").at(3), "1.04");
  EXPECT_EQ(radiosity.at("cells").at(3), "0.96");
  EXPECT_EQ(radiosity.at("panel:back").at(3), "2");
  EXPECT_EQ(radiosity.count("cells:back"), 0u);
}

TEST(PatchesByHand, AreNamedWhereTheBaseIsAsked) {
  const Workplace place;
  place.write("plane.json", with(kPlane, R"(, "on": "room")"));
  place.write("space.json", with(kSpace, R"(, "on": "panel")"));
  const Outcome plane = place.run("hottel visibility plane.json --on 'room[0]' --at 1/2"),
                space = place.run("hottel visibility space.json --on panel --at 1/2,1/2");
  EXPECT_EQ(plane.code, 1);
  EXPECT_THAT(plane.err, HasSubstr("the patch 'window'"));
  EXPECT_EQ(space.code, 1);
  EXPECT_THAT(space.err, HasSubstr("the patch 'cells'"));
  EXPECT_EQ(place.run("hottel visibility plane.json --on 'room[0]' --at 1/6").code, 0);
  EXPECT_EQ(place.run("hottel visibility space.json --on panel --at 1/20,1/2").code, 0);
  EXPECT_EQ(place.run("hottel visibility space.json --on cells --at 1/2,1/2").code, 0);
}

TEST(PatchesByHand, AreCheckedAndKept) {
  const Workplace place;
  for (const auto& [name, text] :
       {std::pair{"plane", with(kPlane, R"(, "on": "room")")}, {"space", with(kSpace, R"(, "on": "panel:back")")}}) {
    place.write("scene.json", text);
    if (name == std::string("space")) {
      EXPECT_THAT(place.run("hottel check scene.json").err, HasSubstr("looks the other way than the back of 'panel'"));
      continue;
    }
    const Json report = Json::parse(place.run("hottel check scene.json --json --quiet").out);
    EXPECT_EQ(report["findings"].size(), 0u) << report;
    ASSERT_EQ(place.run("hottel convert scene.json again.json").code, 0);
    EXPECT_THAT(place.read("again.json"), HasSubstr(R"("on": "room")"));
    EXPECT_EQ(place.run("hottel factors scene.json --quiet").out, place.run("hottel factors again.json --quiet").out);
  }
}

TEST(PatchesByHand, AreRefusedAsTheContractSays) {
  const Workplace place;
  for (const auto& [on, text] :
       {std::pair{R"(, "on": "rom")", "'window' lies on 'rom', but there is no surface or group of that name"},
        {R"(, "on": "window")", "'window' lies on itself"},
        {R"(, "on": "room:back")", "'window' looks the other way than the back of 'room'"},
        {R"(, "on": "room[1]")", "'window' does not lie on 'room[1]'"},
        {R"(, "on": 7)", "\"on\""},
        {R"(, "on": "room", "behind": "solid")", "it makes nothing solid"}}) {
    place.write("scene.json", with(kPlane, on));
    const Outcome refused = place.run("hottel factors scene.json");
    EXPECT_EQ(refused.code, 3) << on;
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("scene.json:3: "), HasSubstr(std::string(text) == "\"on\"" ? "on" : text)));
  }
}

TEST(PatchesByHand, AreDrawnWithDataOn) {
  const Workplace place;
  const std::string drawing = R"(<svg xmlns="http://www.w3.org/2000/svg">
<polygon id="hall" class="white" points="50,50 800,50 800,600 50,600"/>
<line id="window" class="day" x1="50" y1="450" x2="50" y2="200" data-back="white"ON/>
</svg>)";
  place.write("drawing.svg", with(drawing, R"( data-on="hall")"));
  ASSERT_EQ(place.run("hottel convert drawing.svg scene.json").code, 0);
  EXPECT_THAT(place.read("scene.json"), HasSubstr(R"("back": "white", "on": "hall")"));
  EXPECT_EQ(place.run("hottel factors drawing.svg --quiet").out, place.run("hottel factors scene.json --quiet").out);
  place.write("astray.svg", with(drawing, R"( data-on="wall")"));
  EXPECT_THAT(place.run("hottel factors astray.svg").err, HasSubstr("astray.svg:3: 'window' lies on 'wall'"));
}

TEST(PatchesByHand, AreSubsurfacesOfDecksAndHolesOfMeshes) {
  const Workplace place;
  place.write("space.json", with(kSpace, R"(, "on": "panel")"));
  ASSERT_EQ(place.run("hottel convert space.json deck.vs3").code, 0);
  EXPECT_THAT(place.read("deck.vs3"), HasSubstr("S 3  5 6 7 8   1 0   0.8   cells\n"));
  for (const std::string file : {"deck.vs3", "mesh.obj", "mesh.ply", "mesh.stl"}) {
    ASSERT_EQ(place.run("hottel convert space.json " + file).code, 0);
    const Outcome factors = place.run("hottel factors " + file + " --quiet");
    EXPECT_EQ(factors.code, 0) << factors.err;
  }
  EXPECT_THAT(place.run("hottel convert space.json mesh.obj").err,
              HasSubstr("these have holes where patches lie on them, and are cut into convex faces: 'panel'"));
  ASSERT_EQ(place.run("hottel convert space.json mesh.obj && hottel convert mesh.obj back.json").code, 0);
}

// A chain, a patch with a back, one on the back of the base, and one of more corners than a record has.
const std::string kPatchwork = R"({"hottel": 1, "dimension": 3,
  "materials": {"w": {"reflectivity": 0.5}, "g": {"reflectivity": 0.25}, "r": {"reflectivity": 0.75}},
  "polygons": [
    {"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "w", "back": "w"},
    {"name": "rug", "points": [[1,1,0],[3,1,0],[3,3,0],[1,3,0]], "material": "g", "on": "floor", "back": "r"},
    {"name": "spot", "points": [[1.5,1.5,0],[2,1.5,0],[2,2,0],[1.5,2,0]], "material": "r", "on": "rug"},
    {"name": "under", "points": [[0.25,0.25,0],[0.25,0.75,0],[0.75,0.75,0],[0.75,0.25,0]], "material": "g",
     "on": "floor:back"},MORE
    {"name": "lid", "points": [[0,0,2],[0,4,2],[4,4,2],[4,0,2]], "material": "w"},
    {"name": "below", "points": [[0,0,-1],[4,0,-1],[4,4,-1],[0,4,-1]], "material": "w"}]})";

std::string patchwork(const std::string& more) {
  std::string text = kPatchwork;
  return text.replace(text.find("MORE"), 4, more);
}

TEST(PatchesByHand, AreInDecksWhatTheyAreInScenes) {
  const Workplace place;
  place.write("quads.json", patchwork(""));
  place.write("more.json", patchwork(R"({"name": "hex", "points": [[3.2,3.2,0],[3.5,3.1,0],[3.8,3.2,0],[3.8,3.5,0],
    [3.5,3.6,0]], "material": "g", "on": "floor"},)"));
  for (const std::string name : {"quads", "more"}) {
    ASSERT_EQ(place.run("hottel convert " + name + ".json " + name + ".vs3").code, 0);
    const auto scene = table(place.run("hottel factors " + name + ".json --quiet").out, 2),
               deck = table(place.run("hottel factors " + name + ".vs3 --per group --quiet").out, 2);
    std::size_t found = 0;
    for (const auto& [key, row] : scene) {
      if (!key.starts_with("lid,") && !key.starts_with("below,")) continue;
      std::string other = key;
      if (const auto back = other.find(":back"); back != std::string::npos) other.replace(back, 5, "-back");
      ASSERT_EQ(deck.count(other), 1u) << other;
      EXPECT_NEAR(std::stod(deck.at(other).at(2)), std::stod(row.at(2)), 1e-12) << key;
      ++found;
    }
    EXPECT_GE(found, 8u);
  }
  EXPECT_THAT(place.read("quads.vs3"),
              AllOf(HasSubstr("   2 0   0.25   rug-back\n"), HasSubstr("   3 0   0.25   spot\n"),
                    HasSubstr("   2 0   0.75   under\n")));
}

// Walls turned by 24 degrees and typed to six digits, with a patch on the front or the back.
const std::string kTurned = R"({"hottel": 1, "dimension": 3,
  "materials": {"a": {"reflectivity": 0.1}, "b": {"reflectivity": 0.2}, "c": {"reflectivity": 0.3}},
  "polygons": [
    {"name": "wall", "points": [[-0.406737,0.913545,0],[3.247445,2.540492,0],[3.247445,2.540492,3],[-0.406737,0.913545,3]],
     "material": "a"},
    {"name": "win", "points": [WIN], "material": "b", "on": "ON"},
    {"name": "north", "points": [[-1.22021,2.740636,0],[2.433972,4.367583,0],[2.433972,4.367583,3],[-1.22021,2.740636,3]],
     "material": "c"},
    {"name": "south", "points": [[3.247445,0.540492,0],[-0.406737,-1.086455,0],[-0.406737,-1.086455,3],
                                 [3.247445,0.540492,3]], "material": "c"}]})";

// A closed group on a floor, a patch on one of its sides, and one on that, which is listed first.
const std::string kSolid = R"({"hottel": 1, "dimension": 3,
  "materials": {"a": {"reflectivity": 0.1}, "b": {"reflectivity": 0.2}, "c": {"reflectivity": 0.3}},
  "polygons": [
    {"name": "floor", "points": [[0,0,0],[9,0,0],[9,9,0],[0,9,0]], "material": "c"},
    {"name": "top", "group": "box", "points": [[1,1,3],[4,1,3],[4,4,3],[1,4,3]], "material": "a"},
    {"name": "bottom", "group": "box", "points": [[1,1,0],[1,4,0],[4,4,0],[4,1,0]], "material": "a"},
    {"name": "south", "group": "box", "points": [[1,1,0],[4,1,0],[4,1,3],[1,1,3]], "material": "a"},
    {"name": "north", "group": "box", "points": [[4,4,0],[1,4,0],[1,4,3],[4,4,3]], "material": "a"},
    {"name": "west", "group": "box", "points": [[1,4,0],[1,1,0],[1,1,3],[1,4,3]], "material": "a"},
    {"name": "east", "group": "box", "points": [[4,1,0],[4,4,0],[4,4,3],[4,1,3]], "material": "a"},MORE
    {"name": "win", "points": [[2,1,1],[3,1,1],[3,1,2],[2,1,2]], "material": "b", "on": "south"}]})";

const std::string kChain = R"({"hottel": 1, "dimension": 3,
  "materials": {"a": {"reflectivity": 0.1}, "b": {"reflectivity": 0.2}, "c": {"reflectivity": 0.3}},
  "polygons": [
    {"name": "wall", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "a"},
    {"name": "pane", "points": [[1,1,0],[2,1,0],[2,2,0],[1,2,0]], "material": "MP", "on": "win"},
    {"name": "win", "points": [[1,1,0],[3,1,0],[3,3,0],[1,3,0]], "material": "b", "on": "wall"},
    {"name": "lid", "points": [[0,0,2],[0,4,2],[4,4,2],[4,0,2]], "material": "c"}]})";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

// Factors by group, all black backs together.
std::map<std::string, double> factors_by_group(const Workplace& place, const std::string& file) {
  const Outcome outcome = place.run("hottel factors " + file + " --per group --quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::map<std::string, double> sums;
  for (const auto& [key, row] : table(outcome.out, 2))
    if (key != "from,to")
      sums[row.at(0) + "," + (row.at(1).ends_with(":back") ? "backs" : row.at(1))] += std::stod(row.at(2));
  return sums;
}

TEST(PatchesByHand, AreInMeshesAndDecksWhatTheyAreInScenesHoweverCoordinatesAreRounded) {
  const Workplace place;
  place.write("back.json", replaced(replaced(kTurned, "WIN",
                                             "[0.506809,1.320282,2],[2.3339,2.133755,2],[2.3339,2.133755,1],"
                                             "[0.506809,1.320282,1]"),
                                    "ON", "wall:back"));
  place.write("front.json", replaced(replaced(kTurned, "WIN",
                                              "[0.506809,1.320282,1],[2.3339,2.133755,1],[2.3339,2.133755,2],"
                                              "[0.506809,1.320282,2]"),
                                     "ON", "wall"));
  place.write("solid.json", replaced(kSolid, "MORE", ""));
  place.write("solid_chain.json", replaced(kSolid, "MORE", R"({"name": "pane", "points": [[2,1,1],[2.5,1,1],[2.5,1,2],
    [2,1,2]], "material": "c", "on": "win"},)"));
  place.write("chain.json", replaced(kChain, "MP", "c"));
  place.write("chain_alike.json", replaced(kChain, "MP", "a"));
  for (const std::string name : {"back", "front", "solid", "chain", "chain_alike", "solid_chain"}) {
    const std::map<std::string, double> scene = factors_by_group(place, name + ".json");
    for (const std::string ending : {".obj", ".vs3"}) {
      const Outcome convert =
          place.run("hottel convert " + name + ".json " + name + ending + (ending == ".vs3" ? " --per group" : ""));
      ASSERT_EQ(convert.code, 0) << convert.err;
      // What is cut in a deck lies on nothing there that could close with it.
      const bool is_told = convert.err.find("hollow in the file") != std::string::npos;
      EXPECT_EQ(is_told, name == "solid_chain" && ending == ".vs3") << name << ending;
      if (is_told) continue;
      std::map<std::string, double> file = factors_by_group(place, name + ending);
      for (const auto& [pair, factor] : scene) EXPECT_NEAR(file[pair], factor, 1e-9) << name << ending << " " << pair;
      for (const auto& [pair, factor] : file) {
        const double expected = scene.contains(pair) ? scene.at(pair) : 0;
        EXPECT_NEAR(factor, expected, 1e-9) << name << ending << " " << pair;
      }
    }
  }
}

TEST(PatchesByHand, LeaveSolidsHollowOnlyWhereThatIsTold) {
  const Workplace place;
  place.write("solid.json", replaced(kSolid, "MORE", ""));
  for (const std::string file : {"solid.ply", "solid.off", "solid.stl", "solid.vs3"})
    EXPECT_THAT(place.run("hottel convert solid.json " + file).err,
                HasSubstr("solid in the scene, hollow in the file, whose groups do not close: 'box'"));
  EXPECT_THAT(place.run("hottel convert solid.json solid.stl").err,
              HasSubstr("8 of 8 polygons are cut into triangles: 22 faces"));
  ASSERT_EQ(place.run("hottel convert solid.json solid.obj").code, 0);
  EXPECT_THAT(place.read("solid.obj"), AllOf(HasSubstr("o floor\ng floor\n"), HasSubstr("o box\ng box\n")));
  ASSERT_EQ(place.run("hottel convert solid.obj back.json").code, 0);
  EXPECT_EQ(factors_by_group(place, "back.json"), factors_by_group(place, "solid.obj"));
}

// A wall of two triangles, turned and typed to three digits; the window is typed to six.
TEST(PatchesByHand, LieOnMeshesOfCoarserDigits) {
  const Workplace place;
  place.write("wall.obj", "v 0 0 0\nv 2.598 1.5 0\nv 2.598 1.5 2.5\nv 0 0 2.5\ng wall\nf 1 2 3\nf 1 3 4\n");
  place.write("scene.json",
              R"({"hottel": 1, "dimension": 3, "materials": {"w": {"reflectivity": 0.5}, "g": {"emission": 5}},
    "polygons": [{"name": "window", "points": [[0.866025,0.5,0.5],[1.732051,1,0.5],[1.732051,1,1.5],[0.866025,0.5,1.5]],
                  "material": "g", "on": "wall"}],
    "mesh": {"file": "wall.obj", "name": "m", "material": "w"}})");
  const Outcome factors = place.run("hottel factors scene.json --areas");
  EXPECT_EQ(factors.code, 0) << factors.err;
  EXPECT_THAT(place.run("hottel convert scene.json - | hottel factors - --quiet").out, HasSubstr("window,sky,"));
}

// A wall of which the patch is not said is another scene: kept factors of one do not serve the other.
TEST(PatchesByHand, AreTakenFromStoresAsTheyAre) {
  const Workplace place;
  std::string plain = with(kPlane, ""), patched = with(kPlane, R"(, "on": "room")");
  for (std::string* text : {&plain, &patched})
    for (std::size_t at = text->find("\"day\""); at != std::string::npos; at = text->find("\"day\"", at + 1))
      if (at > 100) text->replace(at, 5, "\"white\"");
  const std::string run = "hottel factors scene.json --store kept.store --quiet";
  for (const auto& [first, second] : {std::pair{plain, patched}, {patched, plain}}) {
    place.run("rm -f kept.store");
    place.write("scene.json", first);
    place.run(run);
    place.write("scene.json", second);
    const std::string kept = place.run(run).out, fresh = place.run("hottel factors scene.json --quiet").out;
    EXPECT_EQ(kept, fresh);
  }
}

}  // namespace
}  // namespace hottel::patches_test
