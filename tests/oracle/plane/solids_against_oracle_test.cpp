// Solids, owners, and visibilities in faces, elements and groups, against the oracles: lattice scenes with polylines.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/comparison/plane/engine_comparison.h"
#include "tests/sanitizers.h"
#include "tests/storm/plane/lattice_scene.h"

namespace hottel::oracle::solids_against_oracle_test {
namespace {

constexpr std::uint64_t kScenes = kHasAddressSanitizer ? 20 : 200;

// Scenes that no other run draws, on lattices of 3 to 7 by 3 to 7 points.
storm::LatticeScene scene_at(std::uint64_t number) {
  return storm::lattice_scene(7'000'000 + number, 2 + static_cast<int>(number % 5));
}

TEST(SolidsAgainstOracle, AgreeInEverySideOfTwoThousandScenes) {
  for (std::uint64_t number = 0; number < 10 * kScenes; ++number) {
    const storm::LatticeScene scene = scene_at(number);
    ASSERT_EQ(verdict_differs(to_scene(scene.edges), scene.split), "") << "scene " << number;
  }
}

class VisibilityAgainstOracle : public testing::TestWithParam<Granularity> {};

TEST_P(VisibilityAgainstOracle, IsThatOfThePiecesOfBothAlone) {
  ComparisonCounts counts;
  for (std::uint64_t number = 0; number < kScenes; ++number) {
    std::mt19937_64 random(number);
    Scene2 scene = to_scene(scene_at(number).edges);
    if (GetParam() == Granularity::kElement)
      for (Surface& surface : scene.surfaces) surface.elements = random() % 3 == 0 ? 2 : 1;
    ASSERT_EQ(disagreement(scene, counts, GetParam(), Hidden::kYes), "") << "scene " << number;
  }
  fmt::print("{} scenes: {} pairs, {} sums; {} factors, {} visibilities, {} hidden pairs\n", counts.scenes,
             counts.pairs, counts.sums, counts.factors, counts.visibilities, counts.hidden);
  EXPECT_GT(counts.hidden, kScenes);
}

INSTANTIATE_TEST_SUITE_P(, VisibilityAgainstOracle,
                         testing::Values(Granularity::kFace, Granularity::kElement, Granularity::kGroup),
                         [](const auto& test) {
                           return std::string(test.param == Granularity::kFace      ? "OfFaces"
                                              : test.param == Granularity::kElement ? "OfElements"
                                                                                    : "OfGroups");
                         });

}  // namespace
}  // namespace hottel::oracle::solids_against_oracle_test
