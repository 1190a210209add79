// Neighbours in one plane as one surface.
#include "geometry/space/arrangement/merged_occluders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

namespace hottel::merged_occluders_test {
namespace {

using testing::ElementsAre;

Polygon3 polygon(const std::vector<std::array<int, 3>>& points) {
  Polygon3 result;
  for (const auto& [x, y, z] : points) result.points.push_back({x, y, z});
  return result;
}

// Twice the area of a surface in units of its normal, which is primitive.
Integer area(const Occluders3& occluders, std::uint32_t s) {
  const auto corners = occluders.outline(s);
  const auto at = [&](std::size_t k) { return occluders.vertices().exact(corners[k]); };
  Integer sum = 0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += dot(occluders.exact_normal(s), cross(difference(at(k), at(0)), difference(at(k + 1), at(0))));
  return sum;
}

// (1)
TEST(MergedOccluders3, TwoTrianglesOfAQuadAreOne) {
  const Occluders3 triangles({polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}), polygon({{0, 0, 5}, {2, 0, 5}, {2, 2, 5}}),
                              polygon({{0, 0, 0}, {2, 2, 0}, {0, 2, 0}})});
  const MergedOccluders3 merged(triangles);
  ASSERT_EQ(merged.occluders().size(), 2u);
  EXPECT_EQ(merged.surface_of(0), 0u);
  EXPECT_EQ(merged.surface_of(1), 1u);
  EXPECT_EQ(merged.surface_of(2), 0u);
  EXPECT_THAT(merged.members(0), ElementsAre(0u, 2u));
  EXPECT_EQ(merged.occluders().outline(0).size(), 4u);
  EXPECT_EQ(area(merged.occluders(), 0), 8);
  EXPECT_EQ(merged.occluders().exact_normal(0).z, 1);
}

// (1): only whole edges, one plane, fronts to one side, convex unions.
TEST(MergedOccluders3, WhatIsNotAConvexUnionStays) {
  const Polygon3 base = polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  for (const Polygon3& other :
       {polygon({{2, 0, 0}, {4, 0, 1}, {4, 2, 1}, {2, 2, 0}}), polygon({{2, 0, 0}, {2, 2, 0}, {4, 2, 0}, {4, 0, 0}}),
        polygon({{2, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 3, 0}}), polygon({{2, 0, 0}, {4, -1, 0}, {4, 2, 0}, {2, 2, 0}}),
        polygon({{2, 0, 0}, {4, 0, 0}, {4, 1, 0}, {2, 1, 0}}), polygon({{2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}})})
    EXPECT_EQ(MergedOccluders3(Occluders3({base, other})).occluders().size(), 2u);
}

// (1): what was joined is joined again, across corners at which the outline is straight by then.
TEST(MergedOccluders3, AGridOfTrianglesIsOneQuadWhateverTheOrder) {
  std::vector<Polygon3> triangles;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) {
      triangles.push_back(polygon({{x, y, x}, {x + 1, y, x + 1}, {x + 1, y + 1, x + 1}}));
      triangles.push_back(polygon({{x, y, x}, {x + 1, y + 1, x + 1}, {x, y + 1, x}}));
    }
  const MergedOccluders3 merged{Occluders3(triangles)};
  EXPECT_EQ(merged.occluders().size(), 1u);
  EXPECT_EQ(merged.occluders().outline(0).size(), 4u);
  EXPECT_EQ(area(merged.occluders(), 0), 2 * 32);
  std::mt19937 random(7);
  for (int k = 0; k < 20; ++k) {
    std::shuffle(triangles.begin(), triangles.end(), random);
    const Occluders3 before(triangles);
    const MergedOccluders3 some(before);
    // (1), (2): each polygon once, the area kept, surfaces in the order of their first members, all convex.
    Integer sum = 0;
    std::set<std::uint32_t> seen;
    for (std::uint32_t s = 0; s < some.occluders().size(); ++s) {
      sum += area(some.occluders(), s);
      for (const std::uint32_t member : some.members(s)) {
        EXPECT_EQ(some.surface_of(member), s);
        EXPECT_TRUE(seen.insert(member).second);
      }
      if (s > 0) {
        EXPECT_LT(some.members(s - 1).front(), some.members(s).front());
      }
    }
    EXPECT_EQ(sum, 2 * 32);
    EXPECT_EQ(seen.size(), triangles.size());
    EXPECT_LT(some.occluders().size(), triangles.size() / 2);
  }
}

// (2), (3)
TEST(MergedOccluders3, VerticesStayAndTheUnitPlaysNoPart) {
  for (const int unit : {1, 3}) {
    const auto at = [unit](int x, int y) { return std::array<int, 3>{7 + unit * x, unit * y, 1}; };
    const Occluders3 before({polygon({at(0, 0), at(2, 0), at(1, 1)}), polygon({at(1, 1), at(2, 0), at(2, 2)}),
                             polygon({at(0, 0), at(1, 1), at(0, 2)}), polygon({at(0, 2), at(1, 1), at(2, 2)})});
    const MergedOccluders3 merged(before);
    ASSERT_EQ(merged.occluders().size(), 1u);
    EXPECT_EQ(merged.occluders().vertices().size(), before.vertices().size());
    for (const VertexId3 v : IdRange<VertexId3>(before.vertices().size()))
      EXPECT_TRUE(is_zero(difference(merged.occluders().vertices().exact(v), before.vertices().exact(v))));
    EXPECT_EQ(merged.occluders().outline(0).size(), 4u);
  }
}

}  // namespace
}  // namespace hottel::merged_occluders_test
