// Scenes in space made to order, at the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/space/generate/generators.h"
#include "tests/cli/program.h"

namespace hottel::generate_in_space_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string command(const GeneratorKind3& kind, const std::string& options) {
  return "hottel generate " + kind.name + " --n " + std::to_string(kind.min_n + 3) + " " + options;
}

TEST(GenerateInSpace, SameSeedGivesTheSameBytes) {
  const Workplace place;
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    const Outcome first = place.run(command(kind, "--seed 5")), second = place.run(command(kind, "--seed 5 -o a.json"));
    ASSERT_EQ(first.code, 0) << first.err;
    ASSERT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(second.out, "");
    EXPECT_EQ(first.out, place.read("a.json")) << kind.name;
    EXPECT_NE(place.run(command(kind, "--seed 6")).out, first.out) << kind.name;
    const auto scene = nlohmann::json::parse(first.out);
    EXPECT_EQ(scene["dimension"], 3);
    EXPECT_EQ(lines_of(first.err).back(), std::to_string(scene["polygons"].size()) + " polygons") << kind.name;
  }
}

TEST(GenerateInSpace, WhatIsWrittenIsReadAsItIs) {
  const Workplace place;
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    const Outcome outcome = place.run(command(kind, "-o a.json && hottel convert a.json b.json"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(place.read("a.json"), place.read("b.json")) << kind.name;
  }
}

TEST(GenerateInSpace, AMeshHasTheSamePolygonsAndMaterials) {
  const Workplace place;
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    const Outcome outcome = place.run(command(kind, "--quiet -o a.json") + " && " + command(kind, "-o a.obj") +
                                      " && hottel convert a.obj b.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("not kept in the file")) << kind.name;  // the camera, the sky, ...
    EXPECT_THAT(place.read("a.obj"), HasSubstr("mtllib a.mtl"));
    auto scene = nlohmann::json::parse(place.read("a.json"));
    const auto mesh = nlohmann::json::parse(place.read("b.json"));
    for (auto& polygon : scene["polygons"]) polygon.erase("elements");  // not in the file either
    EXPECT_EQ(scene["polygons"], mesh["polygons"]) << kind.name;
    EXPECT_EQ(scene["materials"], mesh["materials"]) << kind.name;
  }
}

TEST(GenerateInSpace, WithoutBottomsThereIsNothingWhereABoxStands) {
  const Workplace place;
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    const Outcome outcome = place.run(command(kind, "--no-bottoms -o a.json"));
    if (!kind.stands) {
      EXPECT_EQ(outcome.code, 2) << kind.name;
      EXPECT_THAT(outcome.err, HasSubstr("--no-bottoms is an option of kinds in which bodies stand on something"));
      continue;
    }
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::size_t all = nlohmann::json::parse(place.run(command(kind, "")).out)["polygons"].size();
    EXPECT_LT(nlohmann::json::parse(place.read("a.json"))["polygons"].size(), all) << kind.name;
  }
}

// In a closed room the faces seen from the eye of the camera are all that there is.
TEST(GenerateInSpace, TheCameraSeesTheScene) {
  const Workplace place;
  for (const GeneratorKind3& kind : generator_kinds_3()) {
    if (!kind.stands && kind.name != "room-floating" && kind.name != "room-turned") continue;
    const Outcome made =
        place.run("hottel generate " + kind.name + (kind.stands ? " --no-bottoms" : "") + " -o a.json");
    ASSERT_EQ(made.code, 0) << made.err;
    const auto scene = nlohmann::json::parse(place.read("a.json"));
    std::string eye;
    for (const auto& coordinate : scene["camera"]["eye"]) eye += (eye.empty() ? "" : ",") + coordinate.dump();
    const Outcome seen = place.run("hottel visibility a.json --json --at " + eye);
    ASSERT_EQ(seen.code, 0) << seen.err;
    double fraction = 0;
    std::size_t bodies = 0;
    const auto map = nlohmann::json::parse(seen.out);
    for (const auto& face : map["faces"]) {
      const std::string name = face["name"].get<std::string>();
      if (name != "sky") fraction += face["fraction"].get<double>();
      bodies += name != "sky" && !name.starts_with("room[") && !name.starts_with("ground");
    }
    EXPECT_GT(bodies, 5u) << kind.name;
    if (!scene.value("closed", false))
      EXPECT_LT(fraction, 0.6);
    else
      EXPECT_NEAR(fraction, 1, 1e-12) << kind.name;
  }
}

TEST(GenerateInSpace, TheLargestScenesTakeSeconds) {
  const Workplace place;
  const Outcome outcome = place.run("hottel generate triangle-soup --n 100000 -o a.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "100000 polygons\n");
}

TEST(GenerateInSpace, RefusesWhatItCannotMakeAndLeavesFilesAlone) {
  const Workplace place;
  place.write("a.json", "as it was");
  for (const auto& [line, message] : {
           std::pair("room-boxes --n 0 -o a.json", "--n"),
           {"room-boxes --n 100001 -o a.json", "--n must be between 1 and 100000 for room-boxes"},
           {"room-boxes --n 1.5 -o a.json", "--n"},
           {"furnished-room --n 347 -o a.json", "--n must be between 348 and 100000 for furnished-room"},
           {"flat --n 349 -o a.json", "--n must be between 350 and 100000 for flat"},
           {"terrain --n 199 -o a.json", "--n must be between 200 and 100000 for terrain"},
           {"triangle-soup --n 6 -o a.json", "--n must be between 7 and 100000 for triangle-soup"},
           {"room-boxes --digits 9 -o a.json", "--digits: kinds in space have no such option"},
           {"room-boxes --view long -o a.json", "--view and --length: kinds in space have no such option"},
           {"room-boxes --k 5 -o a.json", "--k: kinds in space have no such option"},
           {"room-boxes -o a.png", "generate writes a scene (.json, or - for standard output) or a mesh (.obj"},
           {"maze -o a.obj", "generate writes a scene (.json"},
           {"room-box -o a.json", "there is no kind of scene called 'room-box'"},
       }) {
    const Outcome outcome = place.run(std::string("hottel generate ") + line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << line;
  }
  EXPECT_EQ(place.run("hottel generate room-boxes -o nowhere/a.obj").code, 3);
  EXPECT_EQ(place.read("a.json"), "as it was");
  EXPECT_THAT(place.files(), ElementsAre("a.json"));
}

TEST(GenerateInSpace, HelpListsEveryKind) {
  const Workplace place;
  const Outcome outcome = place.run("hottel generate --help");
  EXPECT_EQ(outcome.code, 0);
  for (const GeneratorKind3& kind : generator_kinds_3()) EXPECT_THAT(outcome.out, HasSubstr("\n  " + kind.name + " "));
}

}  // namespace
}  // namespace hottel::generate_in_space_test
