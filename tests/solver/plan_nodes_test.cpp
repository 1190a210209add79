// What several nodes would take, by the model.
#include "solver/plan_nodes.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel::plan_nodes_test {
namespace {

Plan plan_of(double alone, double shared) {
  return Plan({{Plan::kExchange, true, "", shared},
               {Plan::kInterreflection, true, "", 1},
               {Plan::kPicture, true, "", alone},
               {Plan::kLights, false, "", 0}});
}

MemoryEstimate memory_of(std::uint64_t elements, bool solves = true) {
  std::vector<CountedFace> faces;
  for (std::uint32_t s = 0; s < 6; ++s) faces.push_back({s, false, elements, true});
  return MemoryEstimate(faces, {.solves = solves}, {.element = 1000, .pair = 300, .cached_pair = 100}, 0, {});
}

constexpr double kAsMuchAsItTakes = std::numeric_limits<double>::infinity();

TEST(PlanNodes, TakeLessTimeForWhatIsSharedAndNoMoreForAnythingElse) {
  const Plan plan = plan_of(2, 100);
  const MemoryEstimate memory = memory_of(50);  // 300 unknowns, which are eliminated
  const double of_one_node = 0.1 + 0.9 / 8;
  double before = kAsMuchAsItTakes;
  for (const int count : {1, 2, 4, 64, 1'000'000}) {
    const PlannedNodes nodes = planned_nodes(&plan, 4, 1, memory, {count, 8, kAsMuchAsItTakes});
    EXPECT_DOUBLE_EQ(*nodes.seconds_of_one_core, 103);
    EXPECT_DOUBLE_EQ(*nodes.seconds_of_one_node, 3 + 100 * of_one_node);
    if (count == 1) {
      EXPECT_DOUBLE_EQ(*nodes.seconds, *nodes.seconds_of_one_node);
    }
    EXPECT_LT(*nodes.seconds, before);
    before = *nodes.seconds;
  }
  EXPECT_NEAR(before, 3 + 4 * of_one_node + 96 * of_one_node / 10, 1e-3) << "a tenth, and preparing, are not shared";
}

TEST(PlanNodes, ShareRadiositiesThatAreIterated) {
  const Plan plan({{Plan::kInterreflection, true, "", 10}});
  const auto seconds = [&](std::uint64_t elements, bool solves) {
    return *planned_nodes(&plan, 0, 1, memory_of(elements, solves), {9, 1, 0}).seconds;
  };
  EXPECT_DOUBLE_EQ(seconds(1000, true), 2);
  EXPECT_DOUBLE_EQ(seconds(50, true), 10);
  EXPECT_DOUBLE_EQ(seconds(1000, false), 10);
}

TEST(PlanNodes, GainNothingWhereNothingIsShared) {
  const Plan plan = plan_of(100, 0);
  const PlannedNodes nodes = planned_nodes(&plan, 0, 3, memory_of(50), {50, 8, kAsMuchAsItTakes});
  EXPECT_DOUBLE_EQ(*nodes.seconds, *nodes.seconds_of_one_node);
  EXPECT_DOUBLE_EQ(*nodes.seconds_of_one_core, 303);
}

TEST(PlanNodes, NeedTheMemoryOfOneProcessOnTheFirst) {
  const MemoryEstimate memory = memory_of(1000);
  for (const int count : {1, 2, 1000}) {
    const PlannedNodes nodes = planned_nodes(nullptr, 0, 1, memory, {count, 1, memory.peak()});
    EXPECT_FALSE(nodes.seconds.has_value());
    EXPECT_EQ(nodes.first_bytes, memory.peak());
    EXPECT_TRUE(nodes.fits());
    EXPECT_FALSE(planned_nodes(nullptr, 0, 1, memory, {count, 1, memory.peak() - 1}).fits());
  }
  const auto other = [&](int count) { return planned_nodes(nullptr, 0, 1, memory, {count, 1, 0}).other_bytes; };
  EXPECT_LT(other(2), memory.peak());
  EXPECT_LT(other(20), other(2));
  EXPECT_GT(other(1'000'000), memory.stages()[0].bytes);
  EXPECT_EQ(planned_nodes(nullptr, 0, 1, memory_of(1000, false), {2, 1, 0}).other_bytes, memory.stages()[0].bytes);
}

TEST(PlanNodes, AreAtLeastOneOfOneCore) {
  EXPECT_THROW(planned_nodes(nullptr, 0, 1, memory_of(2), {0, 1, 0}), ContractViolation);
  EXPECT_THROW(planned_nodes(nullptr, 0, 1, memory_of(2), {1, 0, 0}), ContractViolation);
}

}  // namespace
}  // namespace hottel::plan_nodes_test
