// Sweeps in the plane that others take part in.
#include "geometry/plane/exchange/sweep_crew.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/plane/exchange/exchange.h"
#include "kernel/support/failure.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/same_matrix.h"
#include "tests/shuffled_work.h"

namespace hottel::sweep_crew_test {
namespace {

using namespace testing_scenes;

ExchangeRequest request_of(const Scene2& scene, bool has_few_rows) {
  ExchangeRequest request{.always_sweeps = true};
  if (has_few_rows) request.rows = RowChoice::of(scene, scene.surfaces.front().name, request.granularity);
  return request;
}

// sum_terms (5)
TEST(SweepCrew2, WhoeverTakesPartTheMatrixAndItsCountsAreTheSame) {
  for (const std::string kind : {"clutter", "lattice", "maze"})
    for (const bool has_few_rows : {false, true}) {
      const PreparedScene2 prepared = prepare(generated(kind, 600, 3));
      const ExchangeRequest request = request_of(prepared.scene, has_few_rows);
      ExchangeReport alone;
      const ExchangeMatrix expected = exact_exchange(prepared, request, &alone);
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        ShuffledCrew2 crew(seed);
        const CrewScope<SweepCrew2> scope(crew);
        ExchangeReport report;
        expect_same(exact_exchange(prepared, request, &report), expected);
        EXPECT_EQ(crew.sweeps(), 1);
        EXPECT_EQ(report.gaps, alone.gaps);
        EXPECT_EQ(report.terms, alone.terms);
        EXPECT_EQ(report.pairs, alone.pairs);
      }
    }
}

// sum_terms (5)
TEST(SweepCrew2, WhatIsLostOrComesTwiceIsNoticed) {
  const PreparedScene2 prepared = prepare(generated("clutter", 200, 3));
  for (const WorkFault fault : {WorkFault::kLost, WorkFault::kTwice})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      ShuffledCrew2 crew(seed, fault);
      const CrewScope<SweepCrew2> scope(crew);
      EXPECT_THROW(exact_exchange(prepared, {.always_sweeps = true}, nullptr), ContractViolation);
    }
}

}  // namespace
}  // namespace hottel::sweep_crew_test
