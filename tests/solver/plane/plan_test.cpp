// What a plan leaves out is not reached.
#include <gtest/gtest.h>

#include <stdexcept>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "kernel/support/failure.h"
#include "solver/plan_speed.h"
#include "solver/plane/scene_plan.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::plan_test {
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

TEST(Plan, AtAnotherSpeedHasAllSecondsTimesIt) {
  const Plan plan = plan_scene(prepare(analytic_scene("furnace")), {.everything = false, .grid_cells = 1000});
  const Plan slower = plan_at_speed(plan, {.slowness = 2.5});
  ASSERT_EQ(plan.effects().size(), slower.effects().size());
  double sum = 0;
  for (std::size_t k = 0; k < plan.effects().size(); ++k) {
    EXPECT_EQ(slower.effects()[k].effect, plan.effects()[k].effect);
    EXPECT_EQ(slower.effects()[k].used, plan.effects()[k].used);
    EXPECT_EQ(slower.effects()[k].seconds_estimate, 2.5 * plan.effects()[k].seconds_estimate);
    sum += plan.effects()[k].seconds_estimate;
  }
  EXPECT_GT(sum, 0);
  EXPECT_THROW(plan_at_speed(plan, {.slowness = 0}), ContractViolation);
}

// What works on all threads takes a part of the time.
TEST(Plan, OnSeveralThreadsTakesLess) {
  const Plan plan = plan_scene(prepare(analytic_scene("furnace")), {.everything = true, .grid_cells = 1000});
  const Plan shared = plan_at_speed(plan, {.slowness = 1, .threads = 4});
  double least = 1, most = 0;
  for (std::size_t k = 0; k < plan.effects().size(); ++k) {
    const double alone = plan.effects()[k].seconds_estimate;
    if (alone == 0) continue;
    const double part = shared.effects()[k].seconds_estimate / alone;
    EXPECT_EQ(part < 1, plan.effects()[k].effect == Plan::kOcclusion || plan.effects()[k].effect == Plan::kIllumination)
        << plan.effects()[k].effect;
    least = std::min(least, part);
    most = std::max(most, part);
  }
  EXPECT_GT(least, 0.25);
  EXPECT_LT(least, 0.5);
  EXPECT_EQ(most, 1);
  EXPECT_THROW(plan_at_speed(plan, {.slowness = 1, .threads = 0}), ContractViolation);
}

// A picture of the light where there is light to draw.
TEST(Plan, ReckonsWithThePictureOfAGrid) {
  EXPECT_TRUE(plan_scene(prepare(convex_polygon(5)), {.everything = false, .grid_cells = 4}).uses(Plan::kPicture));
  EXPECT_TRUE(plan_scene(prepare(convex_polygon(5)), {}).uses(Plan::kPicture));  // of values of faces
  EXPECT_FALSE(plan_scene(prepare(convex_polygon(5)), {.grid_cells = 4, .has_picture = false}).uses(Plan::kPicture));
}

TEST(Plan, WithoutInterreflectionSolvesNothing) {
  Scene2 scene = analytic_scene("square_radiosity");
  EXPECT_EQ(ExactScene(scene).solve().factorizations, 1u);
  for (Material& material : scene.materials) material.reflectivity = {};
  EXPECT_FALSE(plan_scene(prepare(scene), {}).uses(Plan::kInterreflection));
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
}  // namespace hottel::plan_test
