// A scene in space in stages: what is made once, shared, refused and cancelled.
#include "solver/space/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/space/exchange/exchange.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using ::testing::StartsWith;

Scene3 cube() { return read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json"); }

TEST(Simulation3, EveryValueIsThatOfTheFunctionBehindIt) {
  const Simulation3 simulation(cube(), {.factors = {.wants_visibility = true, .wants_measures = true}});
  const auto factors = simulation.factors();
  const ExchangeMatrix expected = exact_exchange(*simulation.prepared(), {.wants_measures = true});
  ASSERT_EQ(factors->matrix.entry_count(), expected.entry_count());
  for (std::uint32_t i = 0; i < expected.size(); ++i)
    for (std::size_t k = 0; k < expected.row(i).size(); ++k) {
      EXPECT_EQ(factors->matrix.row(i)[k].factor, expected.row(i)[k].factor);
      EXPECT_EQ(factors->matrix.row(i)[k].visibility, expected.row(i)[k].visibility);
      EXPECT_EQ(factors->matrix.measures(i)[k], expected.measures(i)[k]);
    }
  EXPECT_EQ(*simulation.hidden(), hidden_pairs(*simulation.prepared(), Granularity::kFace, expected));
  EXPECT_EQ(factors->report.pairs, 15u);
}

TEST(Simulation3, AStageIsMadeOnceAndSharedWithOtherRequests) {
  const Simulation3 simulation(cube());
  EXPECT_EQ(simulation.factors(), simulation.factors());
  const Simulation3 again = simulation.with_request(simulation.request());
  EXPECT_EQ(again.factors(), simulation.factors());
  EXPECT_EQ(again.radiosities(), simulation.radiosities());
  const Simulation3 looser = simulation.with_request({.factors = {.tolerance = 1e-3}});
  EXPECT_EQ(looser.prepared(), simulation.prepared());
  EXPECT_NE(looser.factors(), simulation.factors());
  EXPECT_NE(looser.radiosities(), simulation.radiosities());
  const Simulation3 other = simulation.with_request({.system = {.solver = Solver::kLu}});
  EXPECT_EQ(other.factors(), simulation.factors());
  EXPECT_EQ(other.hidden(), simulation.hidden());
  EXPECT_NE(other.system(), simulation.system());
  EXPECT_EQ(other.radiosities()->used, Solver::kLu);
  EXPECT_EQ(simulation.with_request({.plan = {.everything = true}}).radiosities(), simulation.radiosities());
}

TEST(Simulation3, ThePlanIsMadeWithoutFactorsAndShared) {
  const Simulation3 simulation(cube());
  EXPECT_FALSE(simulation.plan()->uses(Plan::kOcclusion));
  EXPECT_EQ(simulation.with_request({.factors = {.tolerance = 1e-3}}).plan(), simulation.plan());
  const Simulation3 all = simulation.with_request({.plan = {.everything = true}});
  EXPECT_TRUE(all.plan()->uses(Plan::kOcclusion));
  EXPECT_EQ(all.prepared(), simulation.prepared());
}

TEST(Simulation3, RefusalsNameTheFile) {
  const std::string file = cube().file;
  const Simulation3 small(cube(), {.factors = {.memory = 100}});
  try {
    small.factors();
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), StartsWith(file + ": about 12 elements"));
  }
  Scene3 twice = cube();
  twice.surfaces[1].name = twice.surfaces[0].name;
  EXPECT_THROW(Simulation3{twice}, InputError);
}

TEST(Simulation3, WhoWaitsMayLeaveAndComeBack) {
  struct Leave {};
  const Simulation3 simulation(cube());
  try {
    simulation.factors([](std::string_view, double) { throw Leave(); });
  } catch (const Leave&) {
  }
  EXPECT_EQ(simulation.factors()->matrix.entry_count(), 30u);
}

}  // namespace
}  // namespace hottel
