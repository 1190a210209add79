// Segments near vertices, against the exact distance of every pair.
#include "geometry/plane/check/point_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/scene/closest_point.h"

namespace hottel::point_neighbours_test {
namespace {

TEST(PointNeighbours2, AreAllThatAreInReachAndFewMore) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    const auto draw = [&](long size) { return static_cast<long>(random() % static_cast<std::uint64_t>(size)); };
    PointIndex2 index;
    std::vector<Segment2> segments;
    const bool is_fan = seed % 2 == 0;
    for (int k = 0; k < 60; ++k) {
      const long ax = is_fan ? 0 : draw(1000), ay = is_fan ? 0 : draw(1000), bx = 1 + draw(1000), by = 1 + draw(1000);
      if (ax != bx || ay != by) segments.push_back({index.insert({ax, ay}), index.insert({bx, by})});
    }
    const Vertices2 vertices(index.points(), index.points().size());
    // In the units of the approximate coordinates: those of the scene times this.
    const auto &p = vertices.approximate(segments[0].a), &q = vertices.approximate(segments[0].b);
    const double unit =
        std::hypot(q.x - p.x, q.y - p.y) /
        std::sqrt(
            squared_distance(index.points()[segments[0].a.index()], index.points()[segments[0].b.index()]).get_d());
    const std::vector<long> reach_in_scene{1, 10, 100};
    const long reach = reach_in_scene[seed % 3];
    const auto near = segments_near_vertices(vertices, segments,
                                             std::vector<double>(vertices.size(), static_cast<double>(reach) * unit));
    for (const VertexId v : vertices.ids()) {
      EXPECT_TRUE(std::ranges::is_sorted(near[v.index()]));
      EXPECT_TRUE(std::ranges::adjacent_find(near[v.index()]) == near[v.index()].end());
      for (std::uint32_t s = 0; s < segments.size(); ++s) {
        const Rational squared = closest_point(index.points()[segments[s].a.index()],
                                               index.points()[segments[s].b.index()], index.points()[v.index()])
                                     .squared;
        const bool is_listed = std::ranges::binary_search(near[v.index()], s);
        if (squared <= reach * reach) {
          EXPECT_TRUE(is_listed) << "seed " << seed << ": " << s << " and vertex " << v.index();
        }
        if (squared > 2 * reach * reach) {
          EXPECT_FALSE(is_listed) << "seed " << seed << ": " << s << " and vertex " << v.index();
        }
        const DistanceBounds2 bounds = distance_bounds(vertices, segments[s], v);
        const double distance = std::sqrt(squared.get_d()) * unit;
        EXPECT_LE(bounds.lower, distance);
        EXPECT_GE(bounds.upper, distance);
      }
    }
  }
}

}  // namespace
}  // namespace hottel::point_neighbours_test
