// Ten thousand lattice scenes in every run of the tests (a million: hottel_storm --scenes 1000000), and the storm
// itself.
#include "tests/storm/storm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>

#include "tests/sanitizers.h"

namespace hottel::storm::storm_test {
namespace {

// Under a sanitizer: as many as show each contact often enough.
constexpr std::uint64_t kScenes = kHasAddressSanitizer ? 1'500 : 10'000;

TEST(LatticeStorm, TenThousandScenesObeyTheLaws) {
  StormOptions options;
  options.scenes = kScenes;
  options.threads = 2;
  const StormResult result = run_storm(options);
  const std::string text = report(result);
  std::printf("%s", text.c_str());
  EXPECT_EQ(result.scenes, kScenes);
  EXPECT_EQ(result.all_failures(), 0u) << text;
  for (std::size_t l = 0; l < laws().size(); ++l)
    EXPECT_GE(result.checks[l], kScenes / laws()[l].every) << laws()[l].name;
  for (std::size_t c = 0; c < kContactKinds; ++c)
    EXPECT_GE(result.contacts[c], kScenes / 20) << to_string(static_cast<Contact>(c));
}

TEST(LatticeStorm, IsTheSameForAnyNumberOfThreads) {
  StormOptions options;
  options.scenes = 100;
  options.first = 77;
  const StormResult one = run_storm(options);
  options.threads = 3;
  const StormResult three = run_storm(options);
  EXPECT_EQ(one.checks, three.checks);
  EXPECT_EQ(one.parts, three.parts);
  EXPECT_EQ(one.contacts, three.contacts);
}

bool has_steep_edge(const Edges& edges) {
  return std::any_of(edges.begin(), edges.end(), [](const auto& e) { return abs(e.by - e.ay) > 2 * abs(e.bx - e.ax); });
}

std::string no_steep_edges(const Subject& subject) { return has_steep_edge(subject.edges()) ? "a steep edge\n" : ""; }

TEST(LatticeStorm, ShrinksAFailureToItsCauseAndPrintsItAsAScene) {
  StormOptions options;
  options.scenes = 50;
  const std::vector<Law> planted{{"no steep edges", no_steep_edges, 1}};
  const StormResult result = run_storm(options, planted);
  EXPECT_GT(result.all_failures(), 10u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_EQ(result.examples[0].scene.size(), 1u);
  EXPECT_TRUE(has_steep_edge(result.examples[0].scene));
  const auto& edge = result.examples[0].scene[0];
  EXPECT_EQ(edge.ax + edge.ay + edge.bx + edge.by, 1) << "from (0, 0) to (0, 1) or back";
  const std::string text = report(result, planted);
  EXPECT_THAT(text, testing::HasSubstr("breaks no steep edges"));
  EXPECT_THAT(text, testing::HasSubstr("\"hottel\": 1"));
}

bool has_solid(const Edges& edges) {
  const oracle::Split split = oracle::split(edges);
  return std::any_of(split.pieces.begin(), split.pieces.end(), [](const auto& piece) {
    return piece.left == oracle::kCovered || piece.right == oracle::kCovered;
  });
}

std::string no_solids(const Subject& subject) { return has_solid(subject.edges()) ? "a solid\n" : ""; }

TEST(LatticeStorm, ShrinksScenesWithSolidsAndKeepsTheirPolylinesWhole) {
  StormOptions options;
  options.scenes = 30;
  const std::vector<Law> planted{{"no solids", no_solids, 1}};
  const StormResult result = run_storm(options, planted);
  ASSERT_EQ(result.examples.size(), 1u);
  const Edges& edges = result.examples[0].scene;
  EXPECT_EQ(edges.size(), 3u) << "a triangle";
  EXPECT_TRUE(has_solid(edges));
  EXPECT_FALSE(oracle::split(edges).is_refused());
  EXPECT_THAT(report(result, planted), testing::ContainsRegex("\"closed\": true|\"behind\": \"solid\""));
}

std::string throws(const Subject&) { throw std::runtime_error("too much"); }

TEST(LatticeStorm, TakesAnExceptionForAFailure) {
  StormOptions options;
  options.scenes = 3;
  const StormResult result = run_storm(options, {{"calm", throws, 1}});
  EXPECT_EQ(result.all_failures(), 3u);
  ASSERT_EQ(result.examples.size(), 1u);
  EXPECT_THAT(result.examples[0].what, testing::HasSubstr("too much"));
}

std::string dies(const Subject& subject) {
  if (subject.chance() == 21) std::raise(SIGSEGV);
  return "";
}

TEST(LatticeStormDeathTest, TellsTheSceneAtWhichItDies) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  StormOptions options;
  options.first = 20;
  options.scenes = 3;
  EXPECT_DEATH(run_storm(options, {{"alive", dies, 1}}),
               "at scene 21, law: alive\nagain: hottel_storm --seed 21 --scenes 1 --all --k 3");
}

TEST(LatticeStorm, TellsHowManyScenesAreDone) {
  StormOptions options;
  options.scenes = 5;
  std::vector<std::uint64_t> told;
  options.progress = [&](std::uint64_t done) { told.push_back(done); };
  run_storm(options, {});
  EXPECT_EQ(told, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
}

TEST(LatticeScenes, HaveFewEdgesOnLargeLattices) {
  for (std::uint64_t number = 0; number < 100; ++number) EXPECT_LE(lattice_scene(number, 100).edges.size(), 39u);
}

TEST(LatticeContacts, AreToldApart) {
  const LatticeEdge e{0, 0, 4, 0};
  const auto contact = [&](const LatticeEdge& f) {
    EXPECT_EQ(contact_of(e, f), contact_of(f, e));
    EXPECT_EQ(contact_of(e, f), contact_of(e, {f.bx, f.by, f.ax, f.ay}));
    return contact_of(e, f);
  };
  EXPECT_EQ(contact({0, 1, 4, 1}), Contact::kApart);
  EXPECT_EQ(contact({5, -1, 5, 1}), Contact::kApart);
  EXPECT_EQ(contact({4, 0, 5, 1}), Contact::kTipsMeet);
  EXPECT_EQ(contact({2, 0, 5, 1}), Contact::kTJunction);
  EXPECT_EQ(contact({4, -1, 4, 1}), Contact::kTJunction);
  EXPECT_EQ(contact({2, -1, 3, 1}), Contact::kCrossing);
  EXPECT_EQ(contact({4, 0, 6, 0}), Contact::kEndToEnd);
  EXPECT_EQ(contact({5, 0, 6, 0}), Contact::kCollinearApart);
  EXPECT_EQ(contact({4, 0, 0, 0}), Contact::kEqual);
  EXPECT_EQ(contact({2, 0, 6, 0}), Contact::kPartialOverlap);
  EXPECT_EQ(contact({1, 0, 2, 0}), Contact::kContained);
  EXPECT_EQ(contact({0, 0, 2, 0}), Contact::kContained);
  ContactCounts counts{};
  count_contacts({{0, 0, 4, 4}, {0, 4, 4, 0}, {2, 0, 2, 4}}, counts);
  EXPECT_EQ(counts[static_cast<std::size_t>(Contact::kCrossing)], 3u);
  EXPECT_EQ(counts[static_cast<std::size_t>(Contact::kThreeThroughOnePoint)], 1u);
  EXPECT_EQ(counts[static_cast<std::size_t>(Contact::kThreeTipsOnOneLine)], 1u) << "(4,4), (0,4) and (2,4)";
}

}  // namespace
}  // namespace hottel::storm::storm_test
