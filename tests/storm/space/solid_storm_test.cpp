// Some scenes of solids in every run of the tests (more: hottel_storm --dimension 3 --solids), and the storm itself.
#include "tests/storm/space/solid_storm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>

#include "tests/sanitizers.h"

namespace hottel::storm::solid_storm_test {
namespace {

constexpr std::uint64_t kScenes = kHasAddressSanitizer ? 20 : 75;

TEST(SolidStorm3, ManyScenesObeyTheLaws) {
  StormOptions options;
  options.scenes = kScenes;
  options.threads = 2;
  const SolidStormResult3 result = run_solid_storm_3(options);
  const std::string text = report(result);
  std::printf("%s", text.c_str());
  EXPECT_EQ(result.scenes, kScenes);
  EXPECT_EQ(result.all_failures(), 0u) << text;
  for (std::size_t l = 0; l < solid_laws_3().size(); ++l)
    EXPECT_GE(result.checks[l], kScenes / solid_laws_3()[l].every * 3 / 4) << solid_laws_3()[l].name;
  for (std::size_t s = 0; s < kSolidSights3; ++s)
    EXPECT_GE(result.sights[s], kScenes / 40 + 1) << to_string(static_cast<SolidSight3>(s));
}

TEST(SolidStorm3, IsTheSameForAnyNumberOfThreads) {
  StormOptions options;
  options.scenes = kHasAddressSanitizer ? 3 : 12;
  options.first = 77;
  const SolidStormResult3 one = run_solid_storm_3(options);
  options.threads = 3;
  const SolidStormResult3 three = run_solid_storm_3(options);
  EXPECT_EQ(one.checks, three.checks);
  EXPECT_EQ(one.parts, three.parts);
  EXPECT_EQ(one.sights, three.sights);
}

std::string nothing_is_covered(const SolidSubject3& subject) {
  for (const Piece3& piece : subject.prepared().arrangement().pieces())
    for (const Piece3::Side& side : piece.sides)
      if (side.cover == Piece3::Cover::kPartly) return "covered\n";
  return "";
}

TEST(SolidStorm3, ShrinksAFailureToItsCauseAndPrintsItAsAScene) {
  StormOptions options;
  options.scenes = 30;
  const std::vector<SolidLaw3> planted{{"nothing is covered in part", nothing_is_covered, 1}};
  const SolidStormResult3 result = run_solid_storm_3(options, planted);
  EXPECT_GT(result.all_failures(), 2u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_LE(result.examples[0].scene.size(), 2u);
  EXPECT_TRUE(is_valid_3(result.examples[0].scene));
  const std::string text = report(result, planted);
  EXPECT_THAT(text, testing::HasSubstr("breaks nothing is covered in part"));
  EXPECT_THAT(text, testing::HasSubstr("\"dimension\": 3"));
}

std::string throws(const SolidSubject3&) { throw std::runtime_error("too much"); }

TEST(SolidStorm3, TakesAnExceptionForAFailure) {
  StormOptions options;
  options.scenes = 3;
  const SolidStormResult3 result = run_solid_storm_3(options, {{"calm", throws, 1, true}});
  EXPECT_EQ(result.all_failures(), 3u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_EQ(result.examples[0].scene.size(), 1u);
  EXPECT_THAT(result.examples[0].what, testing::HasSubstr("too much"));
}

std::string dies(const SolidSubject3& subject) {
  if (subject.chance() == 21) std::raise(SIGSEGV);
  return "";
}

TEST(SolidStorm3DeathTest, TellsTheSceneAtWhichItDies) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  StormOptions options;
  options.first = 20;
  options.scenes = 3;
  EXPECT_DEATH(run_solid_storm_3(options, {{"alive", dies, 1, true}}),
               "at scene 21, law: alive\nagain: hottel_storm --seed 21 --scenes 1 --all --dimension 3 --solids");
}

TEST(SolidScene3, IsValidAndTheSameForItsNumber) {
  for (std::uint64_t number = 0; number < 200; ++number) {
    const SolidBodies3 bodies = solid_bodies_3(number);
    EXPECT_TRUE(is_valid_3(bodies)) << number;
    EXPECT_EQ(bodies, solid_bodies_3(number));
  }
}

}  // namespace
}  // namespace hottel::storm::solid_storm_test
