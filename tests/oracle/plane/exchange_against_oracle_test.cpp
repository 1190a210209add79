// The engine against the brute force: every pair of 500 random scenes, as exact sums of square roots, and every double
// that is printed of them.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/comparison/plane/engine_comparison.h"
#include "tests/oracle/plane/random_scene.h"
#include "tests/sanitizers.h"

namespace hottel::oracle::exchange_against_oracle_test {
namespace {

constexpr int kScenesPerBatch = kHasAddressSanitizer ? 3 : 25;
constexpr int kBatches = 20;

class ExchangeAgainstOracle : public testing::TestWithParam<int> {};

// kScenesPerBatch scenes of 10 to 60 edges, half of them on a lattice: 500 in all, 60 in a build with sanitizers.
TEST_P(ExchangeAgainstOracle, AgreesInEveryPairAsAnExactSum) {
  ComparisonCounts counts;
  for (int k = 0; k < kScenesPerBatch; ++k) {
    const int number = GetParam() * kScenesPerBatch + k;
    const int size = 10 + number * 7 % 51;
    const RandomScene scene = random_scene(1000 + static_cast<std::uint64_t>(number / 2), size, number % 2 == 0);
    ASSERT_EQ(disagreement(to_scene(scene.edges), counts), "") << "scene " << number << " with " << size << " edges";
  }
  fmt::print("{} of {} scenes: {} pairs, {} sums; {} factors ({} of them doubles), {} zeros, {} visibilities\n",
             counts.scenes, kBatches * kScenesPerBatch, counts.pairs, counts.sums, counts.factors, counts.doubles,
             counts.zeros, counts.visibilities);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExchangeAgainstOracle, testing::Range(0, kBatches));

}  // namespace
}  // namespace hottel::oracle::exchange_against_oracle_test
