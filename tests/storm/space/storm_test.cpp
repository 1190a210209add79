// Some hundred lattice scenes of space in every run of the tests (a million: hottel_storm --dimension 3 --scenes
// 1000000), and the storm itself.
#include "tests/storm/space/storm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>

#include "tests/sanitizers.h"
#include "tests/storm/space/shrink.h"

namespace hottel::storm::storm_test {
namespace {

constexpr std::uint64_t kScenes = kHasAddressSanitizer ? 60 : 300;

TEST(LatticeStorm3, HundredsOfScenesObeyTheLaws) {
  StormOptions options;
  options.scenes = kScenes;
  options.threads = 2;
  const StormResult3 result = run_storm_3(options);
  const std::string text = report(result);
  std::printf("%s", text.c_str());
  EXPECT_EQ(result.scenes, kScenes);
  EXPECT_EQ(result.all_failures(), 0u) << text;
  for (std::size_t l = 0; l < laws_3().size(); ++l)
    EXPECT_GE(result.checks[l], kScenes / laws_3()[l].every) << laws_3()[l].name;
  for (std::size_t c = 0; c < kContactKinds3; ++c)
    EXPECT_GE(result.contacts[c], kScenes / 10) << to_string(static_cast<Contact3>(c));
  // Pairs that are found whole only along edges come once in some hundred scenes: see pair_integrator_test.cpp for one.
  for (const Settled3 kind : {Settled3::kHidden, Settled3::kClear, Settled3::kHiddenAlongEdges, Settled3::kMixed})
    EXPECT_GE(result.settled[static_cast<std::size_t>(kind)], kScenes / 150) << to_string(kind);
}

// Needles, arcs of nearly half a turn, planes of the hull that doubles do not know, patches at grazing angles: corners
// moved by 2^-57 to 2^-66; feet between points of a thousand bits; a line that passes another at 2^-60; events 2^-27
// apart.
TEST(LatticeStorm3, ScenesThatOnceFailedObeyTheLaws) {
  for (const std::uint64_t number :
       {2005854, 2009429, 3013989, 3031958, 3044639, 3050579, 3060769, 3097353, 7061249, 8010094, 9046513}) {
    StormOptions options;
    options.first = number;
    options.scenes = 1;
    const StormResult3 result = run_storm_3(options);
    EXPECT_EQ(result.all_failures(), 0u) << report(result);
  }
}

TEST(LatticeStorm3, IsTheSameForAnyNumberOfThreads) {
  StormOptions options;
  options.scenes = 30;
  options.first = 77;
  const StormResult3 one = run_storm_3(options);
  options.threads = 3;
  const StormResult3 three = run_storm_3(options);
  EXPECT_EQ(one.checks, three.checks);
  EXPECT_EQ(one.parts, three.parts);
  EXPECT_EQ(one.contacts, three.contacts);
  EXPECT_EQ(one.settled, three.settled);
}

bool pierces(const Polygons3& polygons) {
  ContactCounts3 counts{};
  count_contacts_3(polygons, counts);
  return counts[static_cast<std::size_t>(Contact3::kPierced)] > 0;
}

std::string nothing_pierces(const Subject3& subject) { return pierces(subject.polygons()) ? "pierced\n" : ""; }

TEST(LatticeStorm3, ShrinksAFailureToItsCauseAndPrintsItAsAScene) {
  StormOptions options;
  options.scenes = 20;
  const std::vector<Law3> planted{{"nothing pierces", nothing_pierces, 1}};
  const StormResult3 result = run_storm_3(options, planted);
  EXPECT_GT(result.all_failures(), 2u);
  ASSERT_EQ(result.examples.size(), 1u);
  const Polygons3& polygons = result.examples[0].scene;
  EXPECT_LE(polygons.size(), 4u);
  EXPECT_TRUE(pierces(polygons));
  EXPECT_TRUE(is_valid_3(polygons));
  for (const oracle::SpacePolygon& polygon : polygons) EXPECT_EQ(polygon.size(), 3u);
  const std::string text = report(result, planted);
  EXPECT_THAT(text, testing::HasSubstr("breaks nothing pierces"));
  EXPECT_THAT(text, testing::HasSubstr("\"dimension\": 3"));
}

std::string throws(const Subject3&) { throw std::runtime_error("too much"); }

TEST(LatticeStorm3, TakesAnExceptionForAFailure) {
  StormOptions options;
  options.scenes = 3;
  const StormResult3 result = run_storm_3(options, {{"calm", throws, 1}});
  EXPECT_EQ(result.all_failures(), 3u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_THAT(result.examples[0].what, testing::HasSubstr("too much"));
}

std::string dies(const Subject3& subject) {
  if (subject.chance() == 21) std::raise(SIGSEGV);
  return "";
}

TEST(LatticeStorm3DeathTest, TellsTheSceneAtWhichItDies) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  StormOptions options;
  options.first = 20;
  options.scenes = 3;
  EXPECT_DEATH(run_storm_3(options, {{"alive", dies, 1}}),
               "at scene 21, law: alive\nagain: hottel_storm --seed 21 --scenes 1 --all --dimension 3");
}

TEST(LatticeScene3, IsValidAndTheSameForItsNumber) {
  for (std::uint64_t number = 0; number < 50; ++number) {
    const LatticeScene3 scene = lattice_scene_3(number);
    EXPECT_GE(scene.polygons.size(), 2u);
    EXPECT_TRUE(is_valid_3(scene.polygons)) << number;
    EXPECT_EQ(scene.polygons, lattice_scene_3(number).polygons);
  }
}

// One polygon more: any of another scene, one that is there already, and halves of one there.
TEST(LatticeScene3, StaysValidWhereItIsValidWithOneMore) {
  int valid = 0, others = 0;
  const auto compare = [&](Polygons3 polygons, const oracle::SpacePolygon& added) {
    const bool stays = stays_valid_3(polygons, added);
    polygons.push_back(added);
    EXPECT_EQ(stays, is_valid_3(polygons));
    ++(stays ? valid : others);
  };
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Polygons3 polygons = lattice_scene_3(number).polygons;
    for (const oracle::SpacePolygon& added : lattice_scene_3(number + 1).polygons) compare(polygons, added);
    const oracle::SpacePolygon& first = polygons[0];
    const oracle::SpacePoint across = first[1] - first[0];
    compare(polygons, first);
    compare(polygons, {first[2], first[1], first[0]});
    compare(polygons, {first[0], first[1], first[1] - oracle::SpacePoint{-across.x, -across.y, -across.z}});
    compare({polygons.begin() + 1, polygons.end()}, first);
  }
  EXPECT_GT(valid, 100);
  EXPECT_GT(others, 100);
}

TEST(LatticeScene3, IsNudgedByNoMoreThanItSays) {
  int nudged = 0;
  for (std::uint64_t number = 0; number < 50; ++number) {
    const Polygons3 before = lattice_scene_3(number).polygons;
    Polygons3 after = before;
    const double most = nudge_3(after, number);
    nudged += most > 0 ? 1 : 0;
    EXPECT_EQ(most > 0, after != before);
    for (std::size_t k = 0; k < before.size(); ++k)
      for (std::size_t c = 0; c < before[k].size(); ++c) {
        const oracle::SpacePoint way = after[k][c] - before[k][c];
        EXPECT_LE(std::sqrt(oracle::dot(way, way).get_d()), most);
      }
  }
  EXPECT_GT(nudged, 20);
}

}  // namespace
}  // namespace hottel::storm::storm_test
