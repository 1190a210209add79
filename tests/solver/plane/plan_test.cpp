// What a plan leaves out is not reached.
#include <gtest/gtest.h>

#include <stdexcept>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "kernel/support/failure.h"
#include "solver/plane/scene_plan.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel {
namespace {

using namespace testing_radiosity;

struct SweepReached : std::runtime_error {
  SweepReached() : std::runtime_error("the sweep is reached") {}
};

// The factors as solve computes them, where every sweep throws.
ExchangeReport exchange_without_sweep(const Scene2& scene, bool everything) {
  const PreparedScene2 prepared = prepare(scene);
  ExchangeReport report;
  exact_exchange(
      prepared,
      {.wants_visibility = false, .always_sweeps = everything, .progress = [](double) { throw SweepReached(); }},
      &report);
  return report;
}

TEST(Plan, WithoutOcclusionReachesNoSweep) {
  for (const Scene2& scene :
       {convex_polygon(17), analytic_scene("square_radiosity"), analytic_scene("hexagon"), convex_polygon(3)}) {
    ExchangeReport report;
    EXPECT_NO_THROW(report = exchange_without_sweep(scene, false));
    EXPECT_FALSE(report.seconds.contains("sweep"));
    EXPECT_TRUE(report.seconds.contains("strings"));
    EXPECT_THROW(exchange_without_sweep(scene, true), SweepReached);
  }
  EXPECT_THROW(exchange_without_sweep(analytic_scene("furnace"), false), SweepReached);
}

// The memory is reckoned from the number of pairs, which is known, not from a sample of sweeps.
TEST(Plan, WithoutOcclusionKnowsItsPairsWithoutLooking) {
  const PreparedScene2 prepared = prepare(convex_polygon(40));
  const std::uint64_t bytes = 40 * 39 / 2 * kBytesPerPair;
  EXPECT_NO_THROW(exact_exchange(prepared, {.memory = bytes}));
  EXPECT_THROW(exact_exchange(prepared, {.memory = bytes - 1}), RequestError);
}

TEST(Plan, WithoutInterreflectionSolvesNothing) {
  Scene2 scene = analytic_scene("square_radiosity");
  EXPECT_EQ(ExactScene(scene).solve().factorizations, 1u);
  for (Material& material : scene.materials) material.reflectivity = {};
  EXPECT_FALSE(plan_scene(scene, {}).uses(Plan::kInterreflection));
  const ExactScene black(scene);
  for (const Solver solver : {Solver::kAuto, Solver::kCholesky, Solver::kCg, Solver::kLu, Solver::kJacobi}) {
    RadiosityOptions options;
    options.solver = solver;
    const RadiositySolution solution = black.solve(options);
    EXPECT_EQ(solution.factorizations, 0u);
    EXPECT_EQ(solution.used, Solver::kAuto);
    EXPECT_TRUE(solution.channels[0].residual_history.empty());
    EXPECT_FALSE(solution.seconds.contains("radiosity"));
    BoundsCheck check;
    check.add(black, solution, scene.materials);
    EXPECT_EQ(check.misses, 0u) << check.first_miss;
    EXPECT_GT(check.checked, 0u);
  }
}

TEST(Plan, SolvesNothingWhereNoLightIs) {
  Scene2 scene = analytic_scene("square_radiosity");
  for (Material& material : scene.materials) material.emission = {};
  const RadiositySolution solution = ExactScene(scene).solve();
  EXPECT_EQ(solution.factorizations, 0u);
  for (const ElementRadiosity& element : solution.channels[0].elements) EXPECT_EQ(element.upper, 0);
}

}  // namespace
}  // namespace hottel
