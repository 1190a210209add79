// Sums of pairs in space that others take part in.
#include "geometry/space/exchange/pair_crew.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/scene/division.h"
#include "geometry/unmeasured_pairs.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/same_matrix.h"
#include "tests/shuffled_work.h"

namespace hottel::pair_crew_test {
namespace {

PreparedScene3 prepared_scene(const std::string& name, std::uint32_t parts) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/" + name);
  divide_into(scene, parts);
  return prepare(std::move(scene));
}

// sum_pairs (7)
TEST(PairCrew3, WhoeverTakesPartTheMatrixAndItsCountsAreTheSame) {
  for (const std::string name : {"space/two_boxes.json", "degenerate/space/boxes_stacked.json", "space/cube.json"})
    for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup}) {
      const PreparedScene3 prepared = prepared_scene(name, 2);
      const ExchangeRequest request{.granularity = granularity, .proves = granularity == Granularity::kGroup};
      ExchangeReport3 alone;
      const ExchangeMatrix expected = exact_exchange(prepared, request, &alone);
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        ShuffledCrew3 crew(seed);
        const CrewScope<PairCrew3> scope(crew);
        ExchangeReport3 report;
        expect_same(exact_exchange(prepared, request, &report), expected);
        EXPECT_EQ(crew.sums(), 1);
        EXPECT_EQ(report.hidden, alone.hidden);
        EXPECT_EQ(report.clear, alone.clear);
        EXPECT_EQ(report.mixed, alone.mixed);
        EXPECT_EQ(report.maps, alone.maps);
        EXPECT_EQ(report.pieces, alone.pieces);
        EXPECT_EQ(report.nodes, alone.nodes);
        EXPECT_EQ(report.signs, alone.signs);
        EXPECT_EQ(report.proof.parts, alone.proof.parts);
        EXPECT_EQ(report.proof.redone, alone.proof.redone);
      }
    }
}

// What a computation within this tolerance is refused with; empty where it is not.
std::string refusal(const PreparedScene3& prepared, double tolerance) {
  try {
    exact_exchange(prepared, {.tolerance = tolerance}, nullptr);
  } catch (const UnmeasuredPairs& error) {
    return error.what();
  }
  return "";
}

TEST(PairCrew3, WhoeverTakesPartRefusalsOfPairsThatAreOpenAreTheSame) {
  const PreparedScene3 prepared = prepared_scene("space/two_boxes.json", 1);
  const std::string expected = refusal(prepared, 1e-17);
  ASSERT_NE(expected, "");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ShuffledCrew3 crew(seed);
    const CrewScope<PairCrew3> scope(crew);
    EXPECT_EQ(refusal(prepared, 1e-17), expected);
  }
}

// sum_pairs (7)
TEST(PairCrew3, WhatIsLostOrComesTwiceIsNoticed) {
  const PreparedScene3 prepared = prepared_scene("space/two_boxes.json", 1);
  for (const WorkFault fault : {WorkFault::kLost, WorkFault::kTwice})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      ShuffledCrew3 crew(seed, fault);
      const CrewScope<PairCrew3> scope(crew);
      EXPECT_THROW(exact_exchange(prepared, {}, nullptr), ContractViolation);
    }
}

TEST(PairCrew3, ThereIsOneAtATime) {
  EXPECT_EQ(CrewScope<PairCrew3>::crew(), nullptr);
  {
    ShuffledCrew3 crew(1);
    const CrewScope<PairCrew3> scope(crew);
    EXPECT_EQ(CrewScope<PairCrew3>::crew(), &crew);
    EXPECT_THROW(CrewScope<PairCrew3>{crew}, ContractViolation);
  }
  EXPECT_EQ(CrewScope<PairCrew3>::crew(), nullptr);
}

}  // namespace
}  // namespace hottel::pair_crew_test
