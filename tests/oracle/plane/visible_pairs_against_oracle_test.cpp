// The visibility graph against all pairs over rationals: lattice scenes, with solids and without.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/plane/visibility/visibility_graph.h"
#include "tests/comparison/plane/ownership.h"
#include "tests/oracle/plane/visible_pairs.h"
#include "tests/sanitizers.h"
#include "tests/storm/plane/lattice_scene.h"

namespace hottel::oracle::visible_pairs_against_oracle_test {
namespace {

TEST(VisiblePairs, OfTwoEdgesThatCross) {
  const auto pairs = visible_pairs(split({{0, 0, 2, 2}, {0, 2, 2, 0}}).pieces);
  ASSERT_EQ(pairs.size(), 8u);  // four halves, four sides of the square; no diagonal past the crossing
  EXPECT_EQ(std::count_if(pairs.begin(), pairs.end(), [](const VisiblePair& p) { return p.is_along; }), 4);
}

TEST(VisiblePairs, DoNotLookThroughASolid) {
  std::vector<InputSegment> box{{0, 0, 1, 0}, {1, 0, 1, 1}, {1, 1, 0, 1}, {0, 1, 0, 0}};
  for (InputSegment& edge : box) edge.group = 0;
  EXPECT_EQ(visible_pairs(split(box).pieces).size(), 4u);
  std::reverse(box.begin(), box.end());  // a room
  for (InputSegment& edge : box) {
    std::swap(edge.ax, edge.bx);
    std::swap(edge.ay, edge.by);
  }
  EXPECT_EQ(visible_pairs(split(box).pieces).size(), 6u);
}

std::vector<VisiblePair> found(const PreparedScene2& prepared) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const std::vector<GraphVertex2> listed = graph_vertices(prepared);
  const auto point = [&](std::uint32_t v) {
    const Point2 p = vertices.to_scene(vertices.exact(listed[v].id));
    return std::pair<mpq_class, mpq_class>(mpq_class(to_string(p.x)), mpq_class(to_string(p.y)));
  };
  std::vector<VisiblePair> result;
  visibility_graph(prepared, [&](std::span<const VisiblePair2> pairs) {
    for (const VisiblePair2& pair : pairs) {
      auto v = point(pair.v), w = point(pair.w);
      if (w < v) std::swap(v, w);
      result.push_back({v, w, pair.along != kNoPiece});
    }
  });
  std::sort(result.begin(), result.end());
  return result;
}

TEST(VisibilityGraphAgainstOracle, HasThePairsOfTwoThousandScenes) {
  constexpr std::uint64_t kScenes = kHasAddressSanitizer ? 200 : 2000;
  std::size_t pairs = 0, along = 0, with_solids = 0;
  for (std::uint64_t number = 0; number < kScenes; ++number) {
    const storm::LatticeScene scene = storm::lattice_scene(9'000'000 + number, 2 + static_cast<int>(number % 5));
    const std::vector<VisiblePair> expected = visible_pairs(scene.split.pieces);
    ASSERT_EQ(found(prepare(to_scene(scene.edges))), expected) << "scene " << number;
    pairs += expected.size();
    along += static_cast<std::size_t>(
        std::count_if(expected.begin(), expected.end(), [](const VisiblePair& p) { return p.is_along; }));
    with_solids += std::any_of(scene.split.pieces.begin(), scene.split.pieces.end(),
                               [](const Segment& s) { return s.left == kCovered || s.right == kCovered; });
  }
  fmt::print("{} scenes, {} with solids: {} pairs, {} along edges\n", kScenes, with_solids, pairs, along);
  EXPECT_GT(pairs, 30 * kScenes);
  EXPECT_GT(with_solids, kScenes / 5);
}

}  // namespace
}  // namespace hottel::oracle::visible_pairs_against_oracle_test
