// What factors in space are said to cost, against what is looked at for all their pairs. Nothing here asks a clock.
#include "solver/space/sampled_cost.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/parallel.h"

namespace hottel::sampled_cost_test {
namespace {

Scene3 generated(const std::string& kind, std::uint64_t n, std::uint64_t seed = 1) {
  return generate_3({.kind = kind, .n = n, .seed = seed});
}

SampledCost3 cost_of(const Scene3& scene) { return sampled_cost(prepare(scene), !scene.closed); }

double factors_of(const SampledCost3& cost) { return cost.pairs + cost.sky; }

// What is looked at for all pairs.
double looks_of(const Scene3& scene) {
  ExchangeReport3 report;
  exact_exchange(prepare(scene), {.wants_visibility = false}, &report);
  return seconds_of_looks_3(report.nodes, report.signs);
}

TEST(SampledCost, ExtrapolatesToAllPairs) {
  for (const auto& [kind, n] : {std::pair("room-boxes", 8),
                                {"room-turned", 6},
                                {"room-piercing", 4},
                                {"street-blocks", 6},
                                {"triangle-soup", 16},
                                {"lattice-boxes", 8}}) {
    const Scene3 scene = generated(kind, static_cast<std::uint64_t>(n), 3);
    const double said = factors_of(cost_of(scene)), looks = looks_of(scene);
    EXPECT_GT(said, looks / 3) << kind;
    EXPECT_LT(said, looks * 3 + 0.02) << kind;
  }
}

TEST(SampledCost, GrowsWithWhatStandsBetween) {
  for (const std::string kind : {"room-boxes", "room-turned", "triangle-soup", "street-blocks", "nested-cubes"}) {
    const double few = factors_of(cost_of(generated(kind, 8))), many = factors_of(cost_of(generated(kind, 20)));
    EXPECT_LT(3 * few, many) << kind;
  }
}

TEST(SampledCost, IsTheSameForAnyNumberOfThreads) {
  const Scene3 scene = generated("street-blocks", 8);
  const auto by_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return cost_of(scene);
  };
  const SampledCost3 one = by_threads(1), two = by_threads(2);
  EXPECT_EQ(one.pairs, two.pairs);
  EXPECT_EQ(one.sky, two.sky);
  EXPECT_EQ(one.measured, two.measured);
}

TEST(SampledCost, TakesASmallPartOfWhatItTells) {
  for (const auto& [kind, n] : {std::pair("room-boxes", 16), {"town", 3}, {"street-blocks", 16}}) {
    const SampledCost3 cost = cost_of(generated(kind, static_cast<std::uint64_t>(n)));
    EXPECT_LT(cost.sampling, factors_of(cost) / 7) << kind;
    EXPECT_GE(cost.measured, 3u) << kind;
  }
}

TEST(SampledCost, OfAStreetIsMostlyThatOfTheSky) {
  const SampledCost3 cost = cost_of(generated("street-blocks", 12));
  EXPECT_GT(cost.sky, cost.pairs);
  EXPECT_GT(cost.pairs, cost.plain);
}

TEST(SampledCost, OfNothingIsNothing) {
  const SampledCost3 cost = cost_of(Scene3());
  EXPECT_EQ(factors_of(cost), 0);
  EXPECT_EQ(cost.measured, 0u);
}

}  // namespace
}  // namespace hottel::sampled_cost_test
