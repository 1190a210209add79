// What CONTRACT says of `hottel plan` on scenes in space.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::plan_in_space_test {
namespace {

using ::testing::HasSubstr;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string scene_file(const std::string& name) {
  return "'" + std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name + "'";
}

TEST(PlanInSpace, ListsEffectsWithReasonsAndSeconds) {
  const Workplace place;
  const Outcome text = place.run("hottel plan " + scene_file("two_boxes.json"));
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(text.err, "");
  EXPECT_EQ(lines_of(text.out).size(), 16u);
  EXPECT_THAT(text.out, HasSubstr("  occlusion               used        17 polygons that may hide each other"));
  EXPECT_THAT(text.out, HasSubstr("  picture                 used        what the camera sees"));

  const auto json = nlohmann::json::parse(place.run("hottel plan --json " + scene_file("two_boxes.json")).out);
  EXPECT_EQ(json["hottel"], 1);
  ASSERT_EQ(json["plan"].size(), 15u);
  for (const auto& effect : json["plan"]) {
    EXPECT_EQ(effect.size(), 4u);
    EXPECT_TRUE(effect["used"].is_boolean());
    EXPECT_FALSE(effect["reason"].get<std::string>().empty());
    EXPECT_EQ(effect["seconds_estimate"].get<double>() == 0, effect["seconds_estimate"].get<double>() <= 0);
    if (!effect["used"].get<bool>()) {
      EXPECT_EQ(effect["seconds_estimate"], 0);
    }
  }
  EXPECT_EQ(json["plan"][0]["effect"], "exchange");
  EXPECT_GT(json["plan"][0]["seconds_estimate"].get<double>(), 0);
}

TEST(PlanInSpace, KnowsAConvexRoom) {
  const Workplace place;
  const Outcome outcome = place.run("hottel plan " + scene_file("cube.json"));
  EXPECT_THAT(outcome.out, HasSubstr("  occlusion               not needed  one convex room"));
  EXPECT_THAT(outcome.out, HasSubstr("  sky                     not needed  one closed room"));
}

TEST(PlanInSpace, ElementsAreDividedAsAskedFor) {
  const Workplace place;
  const std::string cube = scene_file("cube.json");
  EXPECT_THAT(place.run("hottel plan --elements 2 " + cube).out, HasSubstr("24 rows, about 240 pairs"));
  EXPECT_THAT(place.run("hottel plan --element-size 1/3 " + cube).out, HasSubstr("54 rows, about 1215 pairs"));
}

// What light costs by the way it is asked for: more where it is gathered, or averaged over cells.
TEST(PlanInSpace, CountsGatheredLightTexelsAndAverages) {
  const Workplace place;
  const auto seconds = [&](const std::string& asked, const std::string& effect) {
    const Outcome outcome = place.run("hottel plan --json " + asked);
    const auto json = nlohmann::json::parse(outcome.out);
    for (const auto& each : json["plan"])
      if (each["effect"] == effect) return each["seconds_estimate"].get<double>();
    return 0.0;
  };
  const std::string boxes = scene_file("two_boxes.json");
  EXPECT_GT(seconds(boxes + " --shading gathered", "picture"), 3 * seconds(boxes, "picture"));
  EXPECT_GT(seconds(boxes + " --elements 4 --shading gathered", "picture"),
            2 * seconds(boxes + " --shading gathered", "picture"));
  EXPECT_EQ(seconds(boxes, "texels"), 0);
  const double few = seconds(boxes + " --texels floor=20x20", "texels");
  EXPECT_NEAR(seconds(boxes + " --texels floor=40x40", "texels"), 4 * few, 0.5 * few);
  std::string scene = testing_cli::contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json");
  scene.replace(scene.find("\"closed\""), 8,
                R"("grid": {"origin": [0, 0, 1], "u": [5, 0, 0], "v": [0, 5, 0], "cells": [8, 8]}, "closed")");
  place.write("boxes.json", scene);
  EXPECT_GT(seconds("boxes.json --illumination average", "illumination"), 10 * seconds("boxes.json", "illumination"));
}

TEST(PlanInSpace, AGridIsThatOfTheScene) {
  const Workplace place;
  const Outcome outcome = place.run("hottel plan --grid 3x3 " + scene_file("cube.json"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("this scene has none: add \"grid\""));
  std::string scene = testing_cli::contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json");
  scene.replace(scene.find("\"closed\""), 8,
                R"("grid": {"origin": [0, 0, 0.5], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [3, 2]}, "closed")");
  place.write("cube.json", scene);
  EXPECT_THAT(place.run("hottel plan cube.json").out, HasSubstr("light between the faces, 6 cells"));
  EXPECT_THAT(place.run("hottel plan cube.json --grid 5x4").out, HasSubstr("light between the faces, 20 cells"));
}

TEST(PlanInSpace, AMeshIsASceneByItself) {
  const Workplace place;
  place.write("plates.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\ng low\nf 1 2 3\n");
  const Outcome outcome = place.run("hottel plan plates.obj");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no face has anything before it"));
}

}  // namespace
}  // namespace hottel::plan_in_space_test
