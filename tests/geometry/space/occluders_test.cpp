#include "geometry/space/arrangement/occluders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "geometry/space/predicates/eye.h"
#include "kernel/support/failure.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::occluders_test {
namespace {

Rational ratio(long p, long q) { return Rational(p) / q; }

TEST(Vertices3, AreIntegersWhateverTheScaleAndPlace) {
  const Rational tiny = scaled_by_power_of_two(1, -60);
  const std::vector<Point3> points{{0, 0, 0}, {ratio(1, 3), 0, 0}, {0, ratio(1, 7), 1}, {2, 2, tiny}};
  const Vertices3 vertices(points);
  EXPECT_FALSE(vertices.is_small());
  std::vector<Point3> others;
  for (const Point3& p : points) others.push_back({p.x * 8 + 1'000'000'000, p.y * 8 - ratio(1, 3), p.z * 8});
  const Vertices3 moved(others);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const VertexId3 v(k);
    EXPECT_EQ(vertices.exact(v), moved.exact(v));
    const IntegerVector& form = vertices.exact(v);
    EXPECT_EQ(vertices.origin().x + vertices.scale() * form.x, points[k].x);
    EXPECT_EQ(vertices.origin().y + vertices.scale() * form.y, points[k].y);
    EXPECT_EQ(vertices.origin().z + vertices.scale() * form.z, points[k].z);
    EXPECT_EQ(vertices.from_scene(points[k]), (Point3{form.x, form.y, form.z}));
  }
}

// Every vector in doubles against the integers, for small and large vertices and eyes.
TEST(Eye3, VectorsAreWithinTheirBounds) {
  const Rational tiny = scaled_by_power_of_two(1, -70);
  for (const Rational& corner : {Rational(7), Rational(ratio(1, 3)), Rational(5 + tiny)})
    for (const Rational& place : {Rational(2), Rational(ratio(22, 7)), Rational(1 + tiny / 3)}) {
      const Vertices3 vertices({{0, 0, 0}, {corner, 1, 2}, {3, corner, 1}, {1, 1, 1}});
      Eye3 eye(vertices, {place, 1, ratio(1, 2)});
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        const IntegerVector& exact = eye.exact_toward(VertexId3(k));
        const BoundedVector& w = eye.toward(VertexId3(k));
        // One power of two for all: from any component that is not zero.
        const double scale = eye.unit() / to_double(eye.exact_unit());
        EXPECT_NEAR(w.x * scale, to_double(exact.x), w.error * scale);
        EXPECT_NEAR(w.y * scale, to_double(exact.y), w.error * scale);
        EXPECT_NEAR(w.z * scale, to_double(exact.z), w.error * scale);
      }
    }
}

TEST(Occluders3, LeavesOutStraightCornersAndSharesEdges) {
  const Occluders3 occluders(
      {{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}, {{{2, 0, 0}, {0, 0, 0}, {0, 0, 2}}}});
  EXPECT_EQ(occluders.outline(0).size(), 4u);
  EXPECT_EQ(occluders.edge_count(), 6u);
  EXPECT_EQ(occluders.exact_normal(0), (IntegerVector{0, 0, 1}));
  EXPECT_EQ(occluders.exact_normal(1), (IntegerVector{0, 1, 0}));
  EXPECT_THROW(Occluders3({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}}), ContractViolation);
}

TEST(Occluders3, SidesCoverEveryTier) {
  const Rational tiny = scaled_by_power_of_two(1, -90);
  const Occluders3 occluders({{{{0, 0, 0}, {1, 0, ratio(1, 3)}, {0, 1, ratio(1, 7)}}},
                              {{{1, 1, ratio(10, 21)}, {1, 1, ratio(10, 21) + tiny}, {5, 5, -5}}}});
  SignTier tier;
  EXPECT_EQ(occluders.side_of(VertexId3(5), 0, tier), -1);
  EXPECT_EQ(tier, SignTier::kFilter);
  EXPECT_EQ(occluders.side_of(VertexId3(1), 0, tier), 0);
  EXPECT_EQ(tier, SignTier::kCombinatorial);
  EXPECT_EQ(occluders.side_of(VertexId3(3), 0, tier), 0);
  EXPECT_EQ(tier, SignTier::kExact);
  EXPECT_EQ(occluders.side_of(VertexId3(4), 0, tier), 1);
  EXPECT_EQ(tier, SignTier::kExact);
}

TEST(Occluders3, EveryPolygonIsInOneLeaf) {
  const Occluders3 occluders(oracle::engine_polygons(oracle::lattice_room(1, 3, 1, 1, 3)));
  std::multiset<std::uint32_t> found;
  for (const Occluders3::Node& node : occluders.nodes())
    if (node.left == 0) found.insert(occluders.order().begin() + node.begin, occluders.order().begin() + node.end);
  EXPECT_EQ(found.size(), occluders.size());
  EXPECT_EQ(std::set(found.begin(), found.end()).size(), occluders.size());
}

}  // namespace
}  // namespace hottel::occluders_test
