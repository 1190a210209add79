// Patches against the brute force: random edges on a lattice, with random patches on them and on each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/comparison/plane/ownership.h"
#include "tests/oracle/plane/random_scene.h"
#include "tests/sanitizers.h"

namespace hottel::oracle::patches_against_oracle_test {
namespace {

constexpr int kScenesPerBatch = kHasAddressSanitizer ? 5 : 40, kBatches = 10;

using Random = std::mt19937_64;

int below(int n, Random& random) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); }

// A patch from quarter to quarter of an edge, as that looks or as its back does.
InputSegment patch_on(const std::vector<InputSegment>& edges, std::size_t base, Random& random) {
  const int first = below(4, random), last = first + 1 + below(4 - first, random);
  const InputSegment& e = edges[base];
  const auto at = [](const mpq_class& a, const mpq_class& b, int quarters) {
    return mpq_class(a + quarters * (b - a) / 4);
  };
  InputSegment patch{at(e.ax, e.bx, first), at(e.ay, e.by, first), at(e.ax, e.bx, last),
                     at(e.ay, e.by, last),  below(3, random),      below(3, random) - 1};
  patch.on = {base};
  // The back of a patch without one is not there to lie on.
  patch.is_on_back = below(3, random) == 0 && (e.on.empty() || e.back_material >= 0);
  if (!patch.is_on_back) return patch;
  std::swap(patch.ax, patch.bx);
  std::swap(patch.ay, patch.by);
  return patch;
}

// A solid box of one group, somewhere among the rest; patches lie on it soon.
void add_box(std::vector<InputSegment>& edges, Random& random) {
  const int x = below(6, random), y = below(6, random), w = 1 + below(4, random), h = 1 + below(4, random);
  int group = 0;
  for (const InputSegment& edge : edges) group = std::max(group, edge.group + 1);
  const int material = below(3, random);
  const int corners[5][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}};
  for (int k = 0; k < 4; ++k)
    edges.push_back({corners[k][0], corners[k][1], corners[k + 1][0], corners[k + 1][1], material, -1, group});
  for (int k = 1 + below(3, random); k > 0; --k)
    edges.push_back(patch_on(edges, edges.size() - 4 + static_cast<std::size_t>(below(4, random)), random));
}

std::vector<InputSegment> patched_scene(std::uint64_t seed) {
  Random random(seed);
  std::vector<InputSegment> edges = random_scene(seed, 5 + below(9, random), true).edges;
  if (seed % 2 == 1) add_box(edges, random);
  for (int k = 1 + below(5, random); k > 0; --k)
    edges.push_back(patch_on(edges, static_cast<std::size_t>(below(static_cast<int>(edges.size()), random)), random));
  return edges;
}

class PatchesAgainstOracle : public testing::TestWithParam<int> {};

TEST_P(PatchesAgainstOracle, AgreeInWhoHasWhatAndInEveryPair) {
  ComparisonCounts counts;
  int refused = 0;
  for (int k = 0; k < kScenesPerBatch; ++k) {
    const std::uint64_t seed = 7000 + static_cast<std::uint64_t>(GetParam() * kScenesPerBatch + k);
    const std::vector<InputSegment> edges = patched_scene(seed);
    const Scene2 scene = to_scene(edges);
    const Split expected = split(edges);
    ASSERT_EQ(verdict_differs(scene, expected), "") << "scene " << seed;
    refused += expected.is_refused();
    if (expected.is_refused()) continue;
    ASSERT_EQ(disagreement(scene, counts, Granularity::kFace, Hidden::kYes), "") << "scene " << seed;
  }
  EXPECT_LT(refused, kScenesPerBatch * 3 / 4);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PatchesAgainstOracle, testing::Range(0, kBatches));

}  // namespace
}  // namespace hottel::oracle::patches_against_oracle_test
