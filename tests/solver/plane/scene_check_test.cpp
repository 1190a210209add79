// One tiny scene for each kind of finding, and scenes in which there is nothing to find.
#include "solver/plane/check/scene_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/plane/check/repair.h"
#include "io/scene/scene_json.h"
#include "solver/plane/simulation/simulation.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/solver/plane/check_scenes.h"

namespace hottel::scene_check_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using namespace check_scenes;

TEST(SceneCheck2, FindsNothingInARoomWithALamp) {
  EXPECT_THAT(kinds(found(scene_of(kLamp, rings({kRoom})))), IsEmpty());
}

TEST(SceneCheck2, ConflictingClaimsAreAnErrorAtThePiece) {
  const Scene2 scene =
      scene_of(edge("a", "[0, 0], [2, 0]") + ", " + edge("b", "[1, 0], [3, 0]", "lamp") + ", " +
               edge("c", "[5, 0], [6, 0]", "white", "red") + ", " + edge("d", "[6, 0], [5, 0]", "lamp", "white"));
  const Findings2 findings = found(scene);
  EXPECT_THAT(kinds(findings), ElementsAre("error conflicting-claims", "error conflicting-claims",
                                           "warning nothing-left", "note light-not-checked"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("a", "b"));
  EXPECT_EQ(findings[0].at, (Point2{Rational(3, 2), 0}));
  EXPECT_THAT(findings[0].message, AllOf(HasSubstr("the front of 'a' and the front of 'b' claim the right side"),
                                         HasSubstr("from (1, 0) to (2, 0)"), HasSubstr("'white' and 'lamp'")));
  EXPECT_THAT(names(scene, findings[1]), ElementsAre("c", "d"));
  EXPECT_THAT(findings[1].message, HasSubstr("the back of 'c' and the front of 'd' claim the left side"));
}

TEST(SceneCheck2, AConflictIsToldOnceWhateverLiesOnPartsOfIt) {
  const Scene2 scene = scene_of(edge("a", "[0, 0], [4, 0]") + ", " + edge("b", "[4, 0], [0, 0]", "white", "lamp") +
                                ", " + edge("c", "[1, 0], [3, 0]") + ", " + edge("d", "[2, 0], [2, 1]"));
  const Findings2 findings = found(scene);
  EXPECT_THAT(kinds(findings), ElementsAre("error conflicting-claims", "warning nothing-left", "note t-junction",
                                           "note light-not-checked"));
  EXPECT_EQ(findings[0].at, (Point2{2, 0}));
  EXPECT_THAT(findings[0].message, HasSubstr("claim the right side from (0, 0) to (4, 0)"));
}

TEST(SceneCheck2, ARepeatedSurfaceIsADuplicateOfWhichNothingIsLeft) {
  const Scene2 scene =
      scene_of(edge("a", "[1, 1], [2, 1]", "white", "white") + ", " + edge("b", "[1, 1], [2, 1]") + ", " + kLamp,
               rings({kRoom}));
  const Findings2 findings = found(scene);
  EXPECT_THAT(kinds(findings), ElementsAre("warning duplicate", "warning nothing-left"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("a", "b"));
  EXPECT_THAT(names(scene, findings[1]), ElementsAre("b"));
}

TEST(SceneCheck2, AThinWallListedFromBothSidesIsANote) {
  const Scene2 scene =
      scene_of(edge("a", "[2, 1], [2, 2]") + ", " + edge("b", "[2, 2], [2, 1]", "lamp"), rings({kRoom}));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("note duplicate"));
  EXPECT_THAT(findings[0].message, HasSubstr("thin wall"));
}

TEST(SceneCheck2, AnOverlapTellsWhatLightMeetsOnEachSide) {
  // A box stands on the floor of a room.
  const Scene2 scene =
      scene_of(kLamp, rings({kRoom, R"({"name": "box", "points": [[1,0],[2,0],[2,1],[1,1]], "closed": true,
                                       "material": "white"})"}));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("note overlap", "note t-junction", "note t-junction"));
  const auto overlap = std::find_if(findings.begin(), findings.end(), [](auto& f) { return f.kind == "overlap"; });
  EXPECT_THAT(names(scene, *overlap), ElementsAre("room[3]", "box[0]"));
  EXPECT_EQ(overlap->at, (Point2{Rational(3, 2), 0}));
  EXPECT_THAT(overlap->message,
              HasSubstr("the black back of 'room[3]' on the left side and the solid 'box' on the right; 'box[0]' "
                        "exchanges nothing and has no rows"));
}

TEST(SceneCheck2, AJunctionNamesWhatEndsWhere) {
  const Scene2 scene = scene_of(edge("fin", "[2, 0], [2, 1]", "white", "white") + ", " + kLamp, rings({kRoom}));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("note t-junction"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("fin", "room[3]"));
  EXPECT_EQ(findings[0].at, (Point2{2, 0}));
  EXPECT_THAT(findings[0].message, HasSubstr("'fin' ends inside 'room[3]' at (2, 0)"));
}

TEST(SceneCheck2, ACrossingIsToldAtItsExactPlace) {
  const Scene2 scene = scene_of(edge("a", "[1, 1], [2, 1.5]", "white", "white") + ", " +
                                    edge("b", "[1, 1.5], [3, 1]", "white", "white") + ", " + kLamp,
                                rings({kRoom}));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("note crossing"));
  EXPECT_EQ(findings[0].at, (Point2{Rational(5, 3), Rational(4, 3)}));
  EXPECT_THAT(findings[0].message, HasSubstr("'a' and 'b' cross at (5/3, 4/3)"));
}

TEST(SceneCheck2, ANearMissTellsItsWidthAndTheLightThatPasses) {
  const Scene2 scene =
      scene_of(edge("door", "[2, 0], [2, 2.9999999968]", "white", "white") + ", " + kLamp, rings({kRoom}));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning near-miss", "note t-junction"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("door", "room[1]"));
  EXPECT_THAT(findings[0].message, AllOf(HasSubstr("the end of 'door' is 3.2e-09 from"), HasSubstr("(2, 3)")));
  // Half of the room sees the gap best from the far lower corner: the factor of its wall in closed form.
  const std::size_t place = findings[0].message.find("F = ");
  ASSERT_NE(place, std::string::npos);
  const double leak = std::stod(findings[0].message.substr(place + 4));
  EXPECT_GT(leak, 1e-10);
  EXPECT_LT(leak, 3.2e-9);  // width over the shortest length
}

TEST(SceneCheck2, ALeakIsTheFactorTowardTheGap) {
  // Two strips of length 1 facing each other through a gap of 1e-6 in a wall half way: the strings through the gap.
  const Scene2 scene = scene_of(edge("below", "[1, 0], [-1, 0]") + ", " + edge("above", "[-1, 2], [1, 2]") + ", " +
                                edge("left", "[-1, 1], [-0.0000005, 1]", "white", "white") + ", " +
                                edge("right", "[0.0000005, 1], [1, 1]", "white", "white"));
  const Findings2 findings = found(scene);
  const auto miss = std::find_if(findings.begin(), findings.end(), [](auto& f) { return f.kind == "near-miss"; });
  ASSERT_NE(miss, findings.end());
  const double leak = std::stod(miss->message.substr(miss->message.find("F = ") + 4));
  const double h = 5e-7, crossed = 2 * std::hypot(1 + h, 1.0), uncrossed = 2 * std::hypot(1 - h, 1.0);
  EXPECT_NEAR(leak, (crossed - uncrossed) / (2 * 2), 1e-14);
}

// From the end of 'a', which lies on 'stub', to 'wall': over the end of 'stub', which is no gap to be filled.
TEST(SceneCheck2, ANearMissAlongASurfaceIsToldWithoutItsLeak) {
  const Scene2 scene =
      scene_of(edge("a", "[-1, 1], [0, 0]") + ", " + edge("stub", "[-1, 0], [0.00000001, 0]", "red", "red") + ", " +
               edge("wall", "[0.0000001, -1], [0.0000001, 1]", "red", "red"));
  const Findings2 findings = found(scene);
  const auto miss = std::find_if(findings.begin(), findings.end(), [](auto& f) { return f.kind == "near-miss"; });
  ASSERT_NE(miss, findings.end());
  EXPECT_THAT(names(scene, *miss), ElementsAre("a", "wall"));
  EXPECT_THAT(miss->message, testing::Not(HasSubstr("through the gap")));
}

TEST(SceneCheck2, ATipThatSticksOutIsAnOvershoot) {
  const Scene2 scene = scene_of(edge("door", "[2, 0], [2, 3.0001]", "white", "white") + ", " + kLamp, rings({kRoom}));
  const Findings2 findings = found(scene);
  EXPECT_THAT(kinds(findings), testing::IsSupersetOf({"warning overshoot", "note crossing"}));
  const auto stub = std::find_if(findings.begin(), findings.end(), [](auto& f) { return f.kind == "overshoot"; });
  EXPECT_THAT(stub->message, AllOf(HasSubstr("sticks 1e-04 out of 'room[1]'")));
  EXPECT_THAT(stub->suggestion, HasSubstr("(2, 3)"));
}

TEST(SceneCheck2, ANeedleTellsItsAngle) {
  const Scene2 scene =
      scene_of(edge("a", "[0, 0], [1, 0]", "lamp", "lamp") + ", " + edge("b", "[0, 0], [1, 0.000001]"));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("note needle", "note opening"));
  EXPECT_EQ(findings[0].at, (Point2{0, 0}));
  EXPECT_THAT(findings[0].message, HasSubstr("5.73e-05 degrees"));
}

TEST(SceneCheck2, ARoomOfEdgesWithTheirFrontsOutsideIsInsideOut) {
  const Scene2 scene = scene_of(kLamp + ", " + edge("south", "[0, 0], [4, 0]") + ", " + edge("east", "[4, 0], [4, 3]") +
                                ", " + edge("north", "[4, 3], [0, 3]") + ", " + edge("west", "[0, 3], [0, 0]"));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning inside-out"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("south", "east", "north", "west"));
}

TEST(SceneCheck2, ASolidListedClockwiseIsInsideOut) {
  const Scene2 scene = scene_of(kLamp, rings({kRoom, ring("[1,0.5],[1,1],[2,1],[2,0.5]")}));
  EXPECT_THAT(kinds(found(scene)), ElementsAre("warning inside-out"));
}

TEST(SceneCheck2, AWallThatTurnsItsBackToARoomIsABlackBack) {
  const Scene2 scene = scene_of(kLamp + ", " + edge("south", "[0, 0], [4, 0]") + ", " + edge("west", "[0, 0], [0, 3]") +
                                ", " + edge("north", "[0, 3], [4, 3]") + ", " + edge("east", "[4, 3], [4, 0]"));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning black-back", "note isolated-cell", "note sees-only-sky"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("south"));
  // It would be accepted, and fill the room.
  EXPECT_THAT(findings[0].suggestion, AllOf(HasSubstr("a \"back\""), HasSubstr("would fill the space")));
}

TEST(SceneCheck2, ABrokenPromiseToBeClosedIsAnError) {
  const Scene2 scene = scene_of(kLamp + ", " + edge("west", "[0, 0], [0, 3]") + ", " + edge("north", "[0, 3], [4, 3]") +
                                    ", " + edge("east", "[4, 3], [4, 0]"),
                                ", \"closed\": true");
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("error not-closed"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("lamp", "west", "north", "east"));
  EXPECT_EQ(findings[0].at, (Point2{0, 0}));
  EXPECT_THAT(findings[0].message, HasSubstr("; the end of 'west' at (0, 0) touches nothing"));
}

TEST(SceneCheck2, AnOpeningIsToldByWhatBoundsIt) {
  const std::string walls = edge("west", "[0, 0], [0, 3]") + ", " + edge("north", "[0, 3], [4, 3]") + ", " +
                            edge("east", "[4, 3], [4, 0]") + ", " + edge("south", "[4, 0], [0.01, 0]") + ", " + kLamp;
  for (const bool closed : {true, false}) {
    const Scene2 scene = scene_of(walls, closed ? ", \"closed\": true" : "");
    const Findings2 findings = found(scene);
    ASSERT_THAT(kinds(findings), ElementsAre(closed ? "error not-closed" : "note opening"));
    EXPECT_THAT(names(scene, findings[0]), ElementsAre("west", "north", "east", "lamp"));
    EXPECT_EQ(findings[0].at, (Point2{Rational(1, 200), 0}));
    EXPECT_THAT(findings[0].message, HasSubstr("the opening from (0, 0) to (0.01, 0), 0.01 wide"));
  }
}

TEST(SceneCheck2, AnOpeningMayLieBetweenAnEndAndAnEdge) {
  // A slot between the end of a wall and the middle of another one that goes on.
  const Scene2 scene =
      scene_of(edge("west", "[0, -1], [0, 3]") + ", " + edge("north", "[0, 3], [4, 3]") + ", " +
                   edge("east", "[4, 3], [4, 0]") + ", " + edge("south", "[4, 0], [0.01, 0]") + ", " + kLamp,
               ", \"closed\": true");
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), testing::IsSupersetOf({"error not-closed"}));
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Finding2& finding) {
    return finding.message.find("opening from (0.01, 0) to (0, 0), 0.01 wide") != std::string::npos;
  })) << findings[0].message;
}

TEST(SceneCheck2, AFaceThatStandsInSeveralRoomsCarriesLightAcross) {
  const Scene2 scene = scene_of(edge("wall", "[2, 0], [2, 3]", "white", "white") + ", " + kLamp, rings({kRoom}));
  const Findings2 findings = found(scene);
  ASSERT_THAT(kinds(findings), ElementsAre("warning spans-rooms", "warning spans-rooms", "note t-junction",
                                           "note t-junction", "note isolated-cell", "note isolated-cell"));
  EXPECT_THAT(names(scene, findings[0]), ElementsAre("room[1]"));
  EXPECT_THAT(names(scene, findings[1]), ElementsAre("room[3]"));
}

TEST(SceneCheck2, ElementsThatEndWhereRoomsDoCarryNothingAcross) {
  const auto scene = [](int elements) {
    return scene_of(edge("wall", "[2, 0], [2, 3]", "white", "white") + ", " + kLamp,
                    R"(, "polylines": [{"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true,
                        "material": "white", "elements": )" +
                        std::to_string(elements) + "}]");
  };
  const auto spans = [](const Finding2& finding) { return finding.kind == "spans-rooms"; };
  for (const int elements : {1, 3, 5}) EXPECT_EQ(std::ranges::count_if(found(scene(elements)), spans), 2) << elements;
  for (const int elements : {2, 4}) {
    const std::vector<std::string> told = kinds(found(scene(elements)));
    EXPECT_THAT(told, testing::Not(testing::Contains(HasSubstr("spans-rooms")))) << elements;
    EXPECT_THAT(told, testing::Contains("note dark")) << elements;  // the room without the lamp
  }
}

TEST(SceneCheck2, RoomsWithoutAWayBetweenThemAreIsolatedAndPerhapsDark) {
  const Scene2 scene = scene_of(kLamp, rings({kRoom, ring("[5,0],[5,3],[9,3],[9,0]")}));
  const Findings2 findings = found(scene);
  EXPECT_THAT(kinds(findings), ElementsAre("note isolated-cell", "note isolated-cell", "note dark"));
  EXPECT_THAT(names(scene, findings[2]), ElementsAre("ring[0]", "ring[1]", "ring[2]", "ring[3]"));
}

TEST(SceneCheck2, MaterialsWithoutSurfacesAreToldByName) {
  const Findings2 findings = Simulation2(scene_of(kLamp, rings({kRoom}))).check()->findings;
  EXPECT_EQ(findings.size(), 5u);
  EXPECT_EQ(findings[0].message, "no surface has the material 'black'");
  EXPECT_THAT(findings[0].surfaces, IsEmpty());
}

TEST(SceneCheck2, FindsNothingButTrueNotesInTheScenesOfTheRepository) {
  const std::filesystem::path scenes = std::filesystem::path(HOTTEL_SOURCE_DIR) / "scenes";
  std::size_t count = 0;
  for (const char* folder : {"analytic", "showcase"})
    for (const auto& entry : std::filesystem::directory_iterator(scenes / folder)) {
      if (entry.path().extension() != ".json") continue;
      ++count;
      const auto check = Simulation2(read_scene_2(entry.path())).check();
      for (const Finding2& finding : check->findings) {
        EXPECT_EQ(finding.severity, Severity::kNote) << entry.path() << ": " << finding.message;
        EXPECT_TRUE(
            finding.kind == "no-light" || finding.kind == "slow-convergence" ||
            (entry.path().filename() == "maze.json" && (finding.kind == "t-junction" || finding.kind == "crossing")))
            << entry.path() << ": " << finding.kind << ": " << finding.message;
      }
    }
  EXPECT_GE(count, 30u);
}

TEST(SceneCheck2, FindsTheGapThatWasCutIntoAClosedRoom) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scene2 scene = testing_scenes::generated("clutter", 100, seed);
    scene.closed = true;
    ASSERT_FALSE(has_error(Simulation2(scene).check()->findings));
    Edge2& wall = scene.edges[seed % 4];
    const Point2 end = wall.to;
    const Rational part = Rational(static_cast<long>(seed)) / 1000;
    wall.to = {end.x + part * (wall.from.x - end.x), end.y + part * (wall.from.y - end.y)};
    const Findings2 findings = Simulation2(scene).check()->findings;
    std::vector<Finding2> errors;
    std::ranges::copy_if(findings, std::back_inserter(errors), [](auto& f) { return f.severity == Severity::kError; });
    ASSERT_EQ(errors.size(), 1u) << "seed " << seed;
    EXPECT_EQ(errors[0].kind, "not-closed");
    EXPECT_EQ(errors[0].at, (Point2{(wall.to.x + end.x) / 2, (wall.to.y + end.y) / 2})) << "seed " << seed;
  }
}

TEST(SceneCheck2, RepairsScenesFullOfCoincidencesWithoutFailing) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const char* distance : {"1e-9", "0.3", "5"}) {
      const Scene2 scene = testing_scenes::generated("lattice", 30, seed);
      Repair2 repair = close_gaps(scene, testing_scenes::number(distance));
      reverse_inside_out(repair);
      EXPECT_NO_THROW(validate(repair.scene));
      EXPECT_NO_THROW(Simulation2(repair.scene).check()) << "seed " << seed << ", " << distance;
    }
}

TEST(SceneCheck2, LooksAtScenesFullOfCoincidencesWithoutFailing) {
  std::size_t errors = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Scene2 scene = testing_scenes::generated("lattice", 60, seed);
    const SceneCheck2 check = *Simulation2(scene).check();
    errors += has_error(check.findings);
    EXPECT_EQ(check.factors != nullptr, !std::any_of(check.findings.begin(), check.findings.end(),
                                                     [](auto& f) { return f.kind == "conflicting-claims"; }));
  }
  EXPECT_LT(errors, 20u);
}

}  // namespace
}  // namespace hottel::scene_check_test
