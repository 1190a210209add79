// What is told of solids, and of backs that might be meant to be some.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/plane/check/repair.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/radiosity/radiosity.h"
#include "tests/solver/plane/check_scenes.h"

namespace hottel::scene_check_solids_test {
namespace {

using namespace check_scenes;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string box(const std::string& name, const std::string& x0, const std::string& y0, const std::string& x1,
                const std::string& y1, const std::string& rest = "", const std::string& material = "white") {
  return outline(name,
                 "[" + x0 + "," + y0 + "],[" + x1 + "," + y0 + "],[" + x1 + "," + y1 + "],[" + x0 + "," + y1 + "]",
                 rest, material);
}

// The room is 4 wide and 3 high; a lamp hangs in it.
Scene2 room_with(std::vector<std::string> lines, const std::string& more_edges = "") {
  lines.insert(lines.begin(), kRoom);
  return scene_of(kLamp + (more_edges.empty() ? "" : ", " + more_edges), rings(lines));
}
const std::string kThreeSides = "[3,0],[3,1],[2,1],[2,0]";

// Everything but the contacts.
Findings2 told(const Scene2& scene) {
  Findings2 findings = found(scene);
  std::erase_if(findings, [](const Finding2& finding) {
    return finding.kind == "t-junction" || finding.kind == "overlap" || finding.kind == "crossing";
  });
  return findings;
}
std::vector<std::string> told_kinds(const Scene2& scene) { return kinds(told(scene)); }

// The names of the faces that are told to be covered.
std::vector<std::string> covered(const Scene2& scene) {
  std::vector<std::string> result;
  for (const Finding2& finding : found(scene))
    if (finding.kind == "covered") result.push_back(scene.surfaces[finding.surfaces.front()].name);
  return result;
}

// All emit 1/2 and reflect 1/2, fronts and stated backs: in a closed scene every radiosity is 1.
void expect_isothermal(Scene2 scene) {
  for (Material& material : scene.materials) {
    material.reflectivity = Spectrum::scalar(Rational(1, 2));
    material.emission = Spectrum::scalar(Rational(1, 2));
  }
  const ExchangeMatrix matrix = exact_exchange(prepare(scene));
  const RadiositySolution solution = solve_radiosity(matrix, scene.materials, scene.sky_emission);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i) || matrix.factor(i, matrix.sky()).value > 0) continue;
    const ElementRadiosity& radiosity = solution.channels[0].elements[i];
    EXPECT_LE(radiosity.lower, 1) << matrix.elements()[i].name;
    EXPECT_GE(radiosity.upper, 1) << matrix.elements()[i].name;
    EXPECT_LT(radiosity.upper - radiosity.lower, 1e-14) << matrix.elements()[i].name;
  }
}

TEST(SolidChecks2, ABoxInARoomIsNothingToWarnOfAndLeavesItIsothermal) {
  for (const Scene2& scene :
       {room_with({box("box", "2", "0", "3", "1")}), room_with({box("box", "0", "1", "1", "1.5")}),
        room_with({box("box", "3", "0", "4", "1")}), room_with({box("box", "2", "1", "3", "2")}),
        room_with({path("box", kThreeSides, R"("behind": "solid")")}),
        room_with({box("box", "2", "0", "3", "1", "", "red")})}) {
    EXPECT_THAT(told_kinds(scene), IsEmpty());
    expect_isothermal(scene);
  }
}

TEST(SolidChecks2, OfBoxesThatTouchTheCoveredFacesAreNoted) {
  const Scene2 equal = room_with({box("a", "2", "0", "3", "1"), box("b", "2", "1", "3", "1.5")});
  EXPECT_THAT(covered(equal), ElementsAre("a[2]", "b[0]"));
  const Scene2 unequal = room_with({box("a", "2", "0", "3.5", "1"), box("b", "2.5", "1", "3", "1.5")});
  EXPECT_THAT(covered(unequal), ElementsAre("b[0]"));
  const Scene2 side = room_with({box("a", "2", "0", "3", "1"), box("b", "3", "0", "3.5", "1")});
  EXPECT_THAT(covered(side), ElementsAre("a[1]", "b[3]"));
  const Scene2 around =
      room_with({box("m", "2", "1", "3", "2"), box("n", "2", "2", "3", "2.5"), box("s", "2", "0.5", "3", "1"),
                 box("e", "3", "1", "3.5", "2"), box("w", "1.75", "1", "2", "2")});
  EXPECT_THAT(covered(around), ElementsAre("m[0]", "m[1]", "m[2]", "m[3]", "n[0]", "s[2]", "e[3]", "w[1]"));
  for (const Scene2& scene : {equal, unequal, side, around}) {
    EXPECT_THAT(told_kinds(scene), Each("note covered"));
    expect_isothermal(scene);
  }
}

TEST(SolidChecks2, AWallThatIsCoveredWhollyIsNotedAndNamesTheSolid) {
  const Scene2 scene = room_with({box("box", "0", "0", "4", "1")});
  const Findings2 findings = told(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("note covered"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("room[3]"));
  EXPECT_THAT(findings[0].message, HasSubstr("the front of 'room[3]' looks into the solid 'box' all along"));
  expect_isothermal(scene);
}

TEST(SolidChecks2, WhatEmitsIntoASolidIsAWarning) {
  const Scene2 scene =
      scene_of(kLamp + ", " + edge("spot", "[3, 0], [2, 0]", "lamp"),
               rings({path("room", "[2,0],[0,0],[0,3],[4,3],[4,0],[3,0]"), box("box", "2", "0", "3", "1")}));
  const Findings2 findings = told(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning covered"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("spot"));
  EXPECT_THAT(findings[0].message, HasSubstr("though it emits"));
  // Not where the solid is as warm.
  for (const auto& [temperature, told_as] : {std::pair(300, "note covered"), {310, "warning covered"}}) {
    Scene2 heat = scene;
    for (Material& material : heat.materials)
      set_gray_body(Spectrum::scalar(Rational(9, 10)), Spectrum::scalar(300), material);
    set_gray_body(Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(temperature),
                  heat.materials[heat.surfaces[*heat.find("spot")].material]);
    EXPECT_THAT(told_kinds(heat), ElementsAre(told_as));
  }
}

TEST(SolidChecks2, APillarDividesTheRoom) {
  const Scene2 scene = room_with({box("pillar", "2", "0", "2.5", "3")});
  EXPECT_THAT(told_kinds(scene),
              ElementsAre("warning spans-rooms", "warning spans-rooms", "note isolated-cell", "note isolated-cell"));
  expect_isothermal(scene);
}

TEST(SolidChecks2, ABoxThatCrossesAWallSeesItsBackFromOutside) {
  const Scene2 scene = room_with({box("box", "3", "1", "5", "2")});
  const Findings2 findings = told(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning black-back", "warning spans-rooms", "warning spans-rooms"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("room[2]"));
}

TEST(SolidChecks2, ASolidThatHoldsOthersIsAskedAbout) {
  const Scene2 nested = room_with({box("big", "2", "0.5", "3", "1.5"), box("small", "2.2", "0.7", "2.5", "1")});
  const Findings2 findings = told(nested);
  ASSERT_THAT(kinds(findings), ElementsAre("warning filled-room"));
  EXPECT_THAT(findings[0].message, AllOf(HasSubstr("'big' is solid"), HasSubstr("'small' is in its interior"),
                                         HasSubstr("was a room meant?")));
  const Scene2 lamp = room_with({box("box", "2", "0", "3", "1")}, edge("bulb", "[2.2, 0.5], [2.5, 0.5]", "lamp"));
  ASSERT_THAT(told_kinds(lamp), ElementsAre("warning filled-room"));
  EXPECT_THAT(told(lamp)[0].message, HasSubstr("the light of 'bulb' is lost"));
  // Two boxes that overlap are one body.
  EXPECT_THAT(told_kinds(room_with({box("a", "2", "0", "3", "1"), box("b", "2.5", "0.5", "3.5", "1.5")})), IsEmpty());
}

TEST(SolidChecks2, ARoomListedTheWrongWayRoundWithFurnitureInItIsOneQuestion) {
  for (const std::string order : {"room first", "room last"}) {
    const std::string room = outline("room", "[0,0],[4,0],[4,3],[0,3]");
    const std::string table = box("table", "2", "0", "3", "1"), chair = box("chair", "2", "1.5", "3", "2");
    const Scene2 scene =
        scene_of(kLamp, order == "room first" ? rings({room, table, chair}) : rings({table, chair, room}));
    const Findings2 findings = found(scene);
    ASSERT_THAT(kinds(findings), ElementsAre("warning filled-room")) << order;
    EXPECT_THAT(findings[0].message, AllOf(HasSubstr("'lamp', "), HasSubstr("'table'"), HasSubstr("'chair'")));
    EXPECT_THAT(findings[0].suggestion, HasSubstr("the other way round (clockwise)"));
    Repair2 repair{scene, {}, {}};
    reverse_inside_out(repair);
    EXPECT_THAT(repair.steps, IsEmpty());  // it is not certain
  }
}

TEST(SolidChecks2, ALoneOutlineListedCounterClockwiseSeesOnlyTheSky) {
  EXPECT_THAT(kinds(found(scene_of("", rings({outline("room", "[0,0],[4,0],[4,3],[0,3]")})))),
              ElementsAre("note sees-only-sky", "note no-light"));
}

TEST(SolidChecks2, ARoomInABuildingIsFree) {
  const Scene2 scene = scene_of(kLamp, rings({box("house", "-1", "-1", "5", "4"), kRoom}));
  EXPECT_THAT(told_kinds(scene), ElementsAre("note isolated-cell", "note sees-only-sky"));
  expect_isothermal(scene);
}

TEST(SolidChecks2, AShelfKeepsItsUnderside) {
  const Scene2 scene =
      room_with({path("shelf", "[2,1],[3.5,1]", R"("back": "white")"), box("box", "2.5", "1", "3", "1.5")});
  EXPECT_THAT(told_kinds(scene), IsEmpty());
  const ExchangeMatrix matrix = exact_exchange(prepare(scene));
  EXPECT_GT(matrix.factor(*matrix.find("shelf[0]"), *matrix.find("room[3]")).value, 0.1);
  expect_isothermal(scene);
}

TEST(SolidChecks2, BlackBacksThatAreSeenAreToldOnceAGroupWithTheLargestLoss) {
  const Scene2 scene = room_with({path("box", kThreeSides)});
  const SceneCheck2 check = *Simulation2(scene).check();
  const Findings2 findings = told(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning black-back"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("box[0]", "box[1]", "box[2]"));
  EXPECT_EQ(findings[0].surfaces, check.black_backs);
  EXPECT_THAT(findings[0].suggestion, HasSubstr("\"behind\": \"solid\""));
  const std::uint32_t floor = *check.factors->find("room[3]");
  double most = 0;
  for (const char* back : {"box[0]:back", "box[1]:back", "box[2]:back"})
    most = std::max(most, check.factors->factor(floor, *check.factors->find(back)).value);
  EXPECT_THAT(findings[0].message, HasSubstr("'room[3]' loses F = " + shortest(most) + " of its light"));
  EXPECT_THAT(findings[0].message, HasSubstr("; so are 2 more of 'box' that others see"));
}

TEST(SolidChecks2, AThinWallOrABoxWithAGapWantsABack) {
  for (const char* points : {"[2,0],[2,2]", "[3,0.01],[3,1],[2,1],[2,0]"}) {
    const Findings2 findings = told(room_with({path("wall", points)}));
    ASSERT_FALSE(findings.empty());
    for (const Finding2& finding : findings) {
      EXPECT_EQ(finding.kind, "black-back");
      EXPECT_EQ(finding.suggestion, "give 'wall' a \"back\", or its material \"two_sided\": true");
    }
  }
}

TEST(SolidChecks2, ARemedyThatWouldFillARoomIsNotNamedAlone) {
  const Scene2 scene = room_with({path("partition", "[2,0],[2,3]")});
  const Findings2 findings = told(scene);
  const auto black = std::find_if(findings.begin(), findings.end(), [](auto& f) { return f.kind == "black-back"; });
  ASSERT_NE(black, findings.end());
  EXPECT_THAT(black->suggestion,
              AllOf(HasSubstr("give 'partition' a \"back\""), HasSubstr("cover 'lamp' and 'room[0]' wholly")));
}

TEST(SolidChecks2, NothingInASolidIsToldOf) {
  // Two posts in a box that cross, nearly touch, and end inside each other.
  const Scene2 scene = room_with({box("box", "2", "0.5", "3", "1.5")}, edge("a", "[2.2, 1], [2.8, 1]") + ", " +
                                                                           edge("b", "[2.5, 0.6], [2.5, 1.4]") + ", " +
                                                                           edge("c", "[2.3, 1.2], [2.4999999, 1.2]"));
  EXPECT_THAT(kinds(found(scene)), ElementsAre("warning filled-room"));
}

TEST(SolidChecks2, WarningsOfASolutionAreThoseOfACheck) {
  for (const Scene2& scene : {room_with({path("box", kThreeSides)}),
                              room_with({box("big", "2", "0.5", "3", "1.5"), box("small", "2.2", "0.7", "2.5", "1")}),
                              scene_of(kLamp, rings({kRoom, ring("[1,0.5],[1,1],[2,1],[2,0.5]")})),
                              room_with({box("box", "2", "0", "3", "1")})}) {
    const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
    std::vector<std::string> expected, warnings;
    for (const Finding2& finding : found(scene))
      if (finding.severity == Severity::kWarning) expected.push_back(finding.message);
    for (const Finding2& finding : lost_light_warnings(prepared, exact_exchange(prepared)))
      warnings.push_back(finding.message);
    EXPECT_EQ(warnings, expected);
  }
}

TEST(SolidChecks2, RefuseABehindThatCannotBeObeyed) {
  for (const std::string points : {"[2,0],[2,2]", "[3,0.01],[3,1],[2,1],[2,0]"})
    EXPECT_THROW(Simulation2(room_with({path("box", points, R"("behind": "solid")")})).check(), InputError) << points;
}

TEST(StateSolids, SaysSolidWhereThatIsCertainAndOnceForEachRegion) {
  Repair2 repair{room_with({path("box", kThreeSides)}), {}, {}};
  state_solids(repair, Simulation2(repair.scene).check()->black_backs);
  ASSERT_EQ(repair.steps.size(), 1u);
  EXPECT_EQ(repair.steps[0].kind, "solid");
  EXPECT_EQ(repair.steps[0].message, "'box' says \"behind\": \"solid\" now");
  EXPECT_THAT(told_kinds(repair.scene), IsEmpty());
  expect_isothermal(repair.scene);

  // Three edges behind which is one region: the first says it.
  Repair2 edges{scene_of(kLamp + ", " + edge("r", "[3, 0], [3, 1]") + ", " + edge("t", "[3, 1], [2, 1]") + ", " +
                             edge("l", "[2, 1], [2, 0]"),
                         rings({kRoom})),
                {},
                {}};
  state_solids(edges, Simulation2(edges.scene).check()->black_backs);
  EXPECT_EQ(edges.steps.size(), 1u);
  EXPECT_THAT(told_kinds(edges.scene), IsEmpty());
}

TEST(StateSolids, DoesNothingWhereAFaceWouldBeCoveredWhollyOrEmits) {
  const std::string box_over_mat = "[3,0],[3,1],[2,1],[2,0]";
  for (const std::string material : {"white", "lamp"}) {
    // A floor in three pieces, the middle one under the box.
    const Scene2 scene =
        scene_of(kLamp + ", " + edge("mat", "[3, 0], [2, 0]", material),
                 rings({path("room", "[2,0],[0,0],[0,3],[4,3],[4,0],[3,0]"), path("box", box_over_mat)}));
    Repair2 repair{scene, {}, {}};
    state_solids(repair, Simulation2(repair.scene).check()->black_backs);
    EXPECT_THAT(repair.steps, ElementsAre(testing::Field(&RepairStep::kind, "not-repaired"))) << material;
    EXPECT_EQ(repair.scene.groups, scene.groups);
  }
  // The floor goes on on both sides, and shines.
  Repair2 repair{
      scene_of("", rings({outline("room", "[0,0],[0,3],[4,3],[4,0]", "", "lamp"), path("box", box_over_mat)})), {}, {}};
  const std::vector<std::uint32_t> backs = Simulation2(repair.scene).check()->black_backs;
  EXPECT_EQ(backs.size(), 3u);
  state_solids(repair, backs);
  EXPECT_THAT(repair.steps, ElementsAre(testing::Field(&RepairStep::kind, "not-repaired")));
}

}  // namespace
}  // namespace hottel::scene_check_solids_test
