// Some scenes of bodies that hide in every run of the tests (more: hottel_storm --dimension 3 --hiding), and the storm
// itself.
#include "tests/storm/space/hiding_storm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>

#include "geometry/space/hiding/hiders.h"
#include "tests/sanitizers.h"
#include "tests/storm/space/matrix_law.h"

namespace hottel::storm::hiding_storm_test {
namespace {

constexpr std::uint64_t kScenes = kHasAddressSanitizer ? 15 : 60;

TEST(HidingStorm3, ManyScenesObeyTheLaws) {
  StormOptions options;
  options.scenes = kScenes;
  options.threads = 2;
  const HidingStormResult3 result = run_hiding_storm_3(options);
  const std::string text = report(result);
  std::printf("%s", text.c_str());
  EXPECT_EQ(result.scenes, kScenes);
  EXPECT_EQ(result.all_failures(), 0u) << text;
  for (std::size_t l = 0; l < hiding_laws_3().size(); ++l)
    EXPECT_GE(result.checks[l], kScenes / hiding_laws_3()[l].every) << hiding_laws_3()[l].name;
  for (std::size_t s = 0; s < kHidingSights3; ++s)
    EXPECT_GE(result.sights[s], kScenes / 4) << to_string(static_cast<HidingSight3>(s));
}

// In slits 2^-54 and 2^-45 wide two rules agree on half of a factor, within 2^-46 of the edges.
TEST(HidingStorm3, RowsStateTheirErrorsWhereTwoRulesAreWrongAlike) {
  for (const std::uint64_t number : {20'446, 20'827}) {
    const MatrixAnswer3 answer = matrix_answer_3(hiding_scene_3(number), number);
    EXPECT_EQ(answer.wrong, "") << number;
    EXPECT_EQ(answer.refusal, "") << number;
  }
}

// An eye was drawn on the edge of a wedge that touches the patch: its rays went through the wedge.
TEST(HidingStorm3, RaysFromWhereSomethingTouchesThePatchTellNothing) {
  StormOptions options;
  options.scenes = 1;
  options.first = 45'087;
  const HidingStormResult3 result = run_hiding_storm_3(options, {hiding_laws_3()[1]});
  ASSERT_STREQ(hiding_laws_3()[1].name, "rays");
  EXPECT_EQ(result.all_checks(), 1u);
  EXPECT_EQ(result.all_failures(), 0u) << report(result, {hiding_laws_3()[1]});
}

// A floor leaves 2^-40 of a wall to see, next to where a slope touches it: what bounds it is nearly zero twice.
TEST(HidingStorm3, NothingIsRefusedWhereAVectorIsNearlyZeroTwice) {
  StormOptions options;
  options.scenes = 1;
  options.first = 106'469;
  const HidingStormResult3 result = run_hiding_storm_3(options, {hiding_laws_3()[4]});
  ASSERT_STREQ(hiding_laws_3()[4].name, "closure");
  EXPECT_EQ(result.all_failures(), 0u) << report(result, {hiding_laws_3()[4]});
}

TEST(HidingStorm3, IsTheSameForAnyNumberOfThreads) {
  StormOptions options;
  options.scenes = 6;
  options.first = 77;
  const HidingStormResult3 one = run_hiding_storm_3(options);
  options.threads = 3;
  const HidingStormResult3 three = run_hiding_storm_3(options);
  EXPECT_EQ(one.checks, three.checks);
  EXPECT_EQ(one.parts, three.parts);
  EXPECT_EQ(one.sights, three.sights);
}

std::string nothing_is_never_first(const HidingSubject3& subject) {
  const Hiders3 hiders(subject.scene().occluders());
  const PlacedPatch3 placed = hiders.placed(subject.rows()[0].patch);
  for (std::uint32_t s = 1; s < subject.polygons().size(); ++s)
    if (hiders.is_never_first(placed, s)) return "never first\n";
  return "";
}

TEST(HidingStorm3, ShrinksAFailureToItsCauseAndPrintsItAsAScene) {
  StormOptions options;
  options.scenes = 4;
  const std::vector<HidingLaw3> planted{{"nothing is never first", nothing_is_never_first, 1}};
  const HidingStormResult3 result = run_hiding_storm_3(options, planted);
  EXPECT_GT(result.all_failures(), 1u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_EQ(result.examples[0].scene.size(), 3u) << "a patch, what is never first from it, and what hides that";
  const std::string text = report(result, planted);
  EXPECT_THAT(text, testing::HasSubstr("breaks nothing is never first"));
  EXPECT_THAT(text, testing::HasSubstr("\"dimension\": 3"));
}

std::string throws(const HidingSubject3&) { throw std::runtime_error("too much"); }

TEST(HidingStorm3, TakesAnExceptionForAFailure) {
  StormOptions options;
  options.scenes = 1;
  const HidingStormResult3 result = run_hiding_storm_3(options, {{"calm", throws, 1}});
  EXPECT_EQ(result.all_failures(), 1u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_EQ(result.examples[0].scene.size(), 2u);
  EXPECT_THAT(result.examples[0].what, testing::HasSubstr("too much"));
}

std::string dies(const HidingSubject3& subject) {
  if (subject.chance() == 21) std::raise(SIGSEGV);
  return "";
}

TEST(HidingStorm3DeathTest, TellsTheSceneAtWhichItDies) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  StormOptions options;
  options.first = 20;
  options.scenes = 3;
  EXPECT_DEATH(run_hiding_storm_3(options, {{"alive", dies, 1}}),
               "at scene 21, law: alive\nagain: hottel_storm --seed 21 --scenes 1 --all --dimension 3 --hiding");
}

TEST(HidingScene3, IsValidAndTheSameForItsNumber) {
  for (std::uint64_t number = 0; number < 30; ++number) {
    const Polygons3 polygons = hiding_scene_3(number);
    EXPECT_GE(polygons.size(), 3u);
    EXPECT_TRUE(is_valid_3(polygons)) << number;
    EXPECT_EQ(polygons, hiding_scene_3(number));
  }
}

}  // namespace
}  // namespace hottel::storm::hiding_storm_test
