// The plan of scenes in space: what is used, what is not, and why.
#include "solver/space/scene_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::scene_plan_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene3 scene_file(const std::string& name) {
  return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
}
Scene3 scene_of(const std::string& polygons, const std::string& more = "") {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [)" +
                           polygons + "]" + more + "}",
                       "scene.json");
}
constexpr const char* kFloor = R"({"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"})";
constexpr const char* kWall = R"({"name": "wall", "points": [[0,0,0],[0,1,0],[0,1,1],[0,0,1]], "material": "m"})";
Scene3 corner() { return scene_of(std::string(kFloor) + ", " + kWall); }

Plan plan_of(const Scene3& scene, const PlanRequest& request) { return plan_scene(prepare(scene), request); }

PlannedEffect effect_of(const Plan& plan, const std::string& name) {
  for (const PlannedEffect& effect : plan.effects())
    if (effect.effect == name) return effect;
  throw std::runtime_error("no effect " + name);
}

TEST(Plan3, ListsEachEffectOnceInOrder) {
  std::vector<std::string> names;
  const Plan plan = plan_of(scene_file("two_boxes.json"), {});
  for (const PlannedEffect& effect : plan.effects()) {
    names.push_back(effect.effect);
    EXPECT_FALSE(effect.reason.empty());
    EXPECT_EQ(effect.used, plan.uses(effect.effect));
    if (!effect.used) {
      EXPECT_EQ(effect.seconds_estimate, 0);
    }
  }
  EXPECT_THAT(names,
              ElementsAre(Plan::kExchange, Plan::kOcclusion, Plan::kBackFaces, Plan::kSky, Plan::kSubdivision,
                          Plan::kGroups, Plan::kChannels, Plan::kInterreflection, Plan::kUnreachable, Plan::kDividing,
                          Plan::kIllumination, Plan::kPicture, Plan::kLights, Plan::kBeams, Plan::kMovement));
  EXPECT_THROW(plan.uses("weather"), ContractViolation);
}

TEST(Plan3, KnowsWhereBeamsEndAndWhatMoves) {
  const Plan stage = plan_of(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/lights/stage.json"), {});
  EXPECT_EQ(effect_of(stage, Plan::kLights).reason, "2 lights");
  EXPECT_EQ(effect_of(stage, Plan::kBeams).reason, "2 beams with a border: --light-levels divides what it crosses");
  EXPECT_TRUE(stage.uses(Plan::kMovement));
  const Plan dark = plan_of(scene_file("two_boxes.json"), {.everything = true});
  EXPECT_FALSE(dark.uses(Plan::kBeams));
  EXPECT_FALSE(dark.uses(Plan::kMovement));
}

TEST(Plan3, NothingHidesInAConvexRoomNorWhereNothingIsFaced) {
  EXPECT_FALSE(plan_of(scene_file("cube.json"), {}).uses(Plan::kOcclusion));
  EXPECT_FALSE(plan_of(scene_of(kFloor), {}).uses(Plan::kOcclusion));
  EXPECT_FALSE(plan_of(scene_of(""), {}).uses(Plan::kOcclusion));
  EXPECT_TRUE(plan_of(scene_file("two_boxes.json"), {}).uses(Plan::kOcclusion));
  // The wall stands between the floor and a part of the sky.
  EXPECT_TRUE(plan_of(corner(), {}).uses(Plan::kOcclusion));
  EXPECT_EQ(effect_of(plan_of(scene_file("cube.json"), {}), Plan::kOcclusion).reason,
            "one convex room: nothing can hide anything");
  EXPECT_EQ(effect_of(plan_of(scene_of(kFloor), {}), Plan::kOcclusion).reason, "no face has anything before it");
}

TEST(Plan3, TheSkyIsSeenUnlessTheSceneIsClosedOrPromisedToBe) {
  EXPECT_TRUE(plan_of(corner(), {}).uses(Plan::kSky));
  EXPECT_FALSE(plan_of(scene_of(kFloor, R"(, "closed": true)"), {}).uses(Plan::kSky));
  Scene3 cube = scene_file("cube.json");
  cube.closed = false;
  EXPECT_EQ(effect_of(plan_of(cube, {}), Plan::kSky).reason, "one closed room");
  const Plan lit = plan_of(scene_of(kFloor, R"(, "sky": {"emission": 1})"), {});
  EXPECT_EQ(effect_of(lit, Plan::kSky).reason, "the sky emits");
}

TEST(Plan3, TellsWhatTheTableOfTheSceneSays) {
  const Plan boxes = plan_of(scene_file("two_boxes.json"), {});
  EXPECT_EQ(effect_of(boxes, Plan::kBackFaces).reason, "1 back with a material");
  EXPECT_THAT(effect_of(boxes, Plan::kGroups).reason, HasSubstr("2 groups of several polygons"));
  EXPECT_TRUE(boxes.uses(Plan::kChannels));
  EXPECT_FALSE(boxes.uses(Plan::kSubdivision));
  Scene3 divided = scene_file("two_boxes.json");
  divided.surfaces[3].elements = 2;
  EXPECT_EQ(effect_of(plan_of(divided, {}), Plan::kSubdivision).reason, "1 polygon divided into elements");
  const Plan cube = plan_of(scene_file("cube.json"), {});
  EXPECT_FALSE(cube.uses(Plan::kGroups));
  EXPECT_FALSE(cube.uses(Plan::kBackFaces));
  EXPECT_FALSE(cube.uses(Plan::kChannels));
}

TEST(Plan3, LightBetweenFacesIsUsedIffThereIsAGrid) {
  for (const bool everything : {false, true}) {
    const Plan plan = plan_of(scene_file("cube.json"), {.everything = everything, .grid_cells = 9});
    const PlannedEffect effect = effect_of(plan, Plan::kIllumination);
    EXPECT_TRUE(effect.used);
    EXPECT_EQ(effect.reason, "light between the faces, 9 cells");
    EXPECT_GT(effect.seconds_estimate, 0);
    const PlannedEffect without =
        effect_of(plan_of(scene_file("cube.json"), {.everything = everything}), Plan::kIllumination);
    EXPECT_FALSE(without.used);
    EXPECT_EQ(without.reason, "no grid is asked for");
    EXPECT_EQ(without.seconds_estimate, 0);
    EXPECT_THAT(effect_of(plan, Plan::kPicture).reason, HasSubstr("what the camera sees"));
    EXPECT_FALSE(plan.uses(Plan::kLights));
    EXPECT_TRUE(plan.uses(Plan::kInterreflection));
    EXPECT_EQ(plan.uses(Plan::kUnreachable), everything);  // one room: light reaches all of it
  }
  const Plan plain = plan_of(scene_of(kFloor), {});
  EXPECT_EQ(effect_of(plain, Plan::kPicture).reason, "what a camera chosen for the scene sees");
  EXPECT_FALSE(plan_of(scene_of(""), {}).uses(Plan::kPicture));
  EXPECT_TRUE(effect_of(plain, Plan::kIllumination).is_simulated);
}

TEST(Plan3, EverythingIsUsedWhereItIsAskedForAndTheReasonSaysSo) {
  const Plan plan = plan_of(scene_file("cube.json"), {.everything = true});
  for (const char* name : {Plan::kOcclusion, Plan::kBackFaces, Plan::kSky, Plan::kSubdivision, Plan::kGroups}) {
    EXPECT_TRUE(plan.uses(name)) << name;
    EXPECT_THAT(effect_of(plan, name).reason, testing::StartsWith("asked for; the scene does not need it: ")) << name;
  }
}

TEST(Plan3, CountsThePairsThatFaceEachOther) {
  const auto text = [](const Scene3& scene) { return effect_of(plan_of(scene, {}), Plan::kExchange).reason; };
  EXPECT_EQ(text(scene_file("cube.json")), "6 rows, about 15 pairs that face each other");
  Scene3 divided = scene_file("cube.json");
  divide_into(divided, 3);
  EXPECT_EQ(text(divided), "54 rows, about 1215 pairs that face each other");  // 15 * 9 * 9
  EXPECT_EQ(text(scene_of(kFloor)), "1 row, about 0 pairs that face each other");
  EXPECT_FALSE(plan_of(scene_of(""), {}).uses(Plan::kExchange));
}

// Of so many faces some pairs are looked at only.
TEST(Plan3, EstimatesThePairsOfManyFaces) {
  std::string plates;
  for (int k = 0; k < 60; ++k) {
    const std::string x = std::to_string(2 * k), y = std::to_string(2 * k + 1);
    plates += std::string(k == 0 ? "" : ", ") + R"({"points": [[)" + x + ",0,0],[" + y + ",0,0],[" + y +
              R"(,1,0]], "material": "m"}, )" + R"({"points": [[)" + x + ",0,1],[" + y + ",1,1],[" + y +
              R"(,0,1]], "material": "m"})";
  }
  const PlannedEffect exchange = effect_of(plan_of(scene_of(plates), {}), Plan::kExchange);
  const double pairs = 60 * 60;  // each low plate and each high one
  const std::string about = "about ";
  EXPECT_NEAR(std::stod(exchange.reason.substr(exchange.reason.find(about) + about.size())), pairs, 0.2 * pairs);
  EXPECT_EQ(exchange.reason, effect_of(plan_of(scene_of(plates), {}), Plan::kExchange).reason);
}

}  // namespace
}  // namespace hottel::scene_plan_test
