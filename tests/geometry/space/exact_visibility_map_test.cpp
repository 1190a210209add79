// Maps with exact planes, against the maps in doubles that they are of.
#include "geometry/space/visibility/exact_visibility_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::exact_visibility_map_test {
namespace {

Direction3 in_doubles(const IntegerVector& a) {
  const BoundedVector w = rounded(a, bits(a) - 53);
  return unit(Direction3{w.x, w.y, w.z});
}

// Boxes that touch, and triangles that pierce each other; eyes on the lattice and anywhere.
std::vector<ExactVisibilityMap3> maps_of(const Occluders3& occluders, std::mt19937_64& engine) {
  std::vector<ExactVisibilityMap3> maps;
  for (int e = 0; e < 3; ++e) {
    const auto coordinate = [&engine, e]() -> Rational {
      Rational result(static_cast<long>(engine() % 60), e == 0 ? 5 : 1 + static_cast<long>(engine() % 30));
      result.canonicalize();
      return result;
    };
    const Rational x = coordinate(), y = coordinate(), z = coordinate();
    maps.emplace_back(occluders, Point3{x, y, z});
  }
  return maps;
}

TEST(ExactVisibilityMap3, ConesAreThoseOfTheMap) {
  std::mt19937_64 engine(1);
  std::size_t crossings = 0;
  for (int n = 0; n < 16; ++n) {
    const auto seed = static_cast<std::uint64_t>(n);
    const auto polygons = n % 2 == 0 ? oracle::lattice_room(seed, 3, 1 + n % 3, 1 + n % 4 / 2, 2)
                                     : oracle::piercing_triangles(seed, 40, 12, 9);
    const Occluders3 occluders(oracle::engine_polygons(polygons));
    for (const ExactVisibilityMap3& map : maps_of(occluders, engine)) {
      for (const PlaneDefinition3& plane : map.map().planes)
        crossings += plane.kind == PlaneDefinition3::Kind::kCrossing;
      ASSERT_EQ(map.size(), map.map().fragments.size());
      for (std::size_t k = 0; k < map.size(); ++k) {
        const VisibilityMap3::Fragment& fragment = map.map().fragments[k];
        const ExactCone3& cone = map.cone(k);
        ASSERT_EQ(cone.corners.size(), fragment.end - fragment.begin);
        const std::vector<Point3> on_face = map.corners_on_face(k);
        for (std::size_t c = 0; c < cone.corners.size(); ++c) {
          const VisibilityMap3::Corner& corner = map.map().corners[fragment.begin + c];
          EXPECT_LT(length(in_doubles(cone.corners[c]) - corner.direction), 1e-11);
          EXPECT_EQ(map.nearness(on_face[c], fragment.face.surface), 0);
          EXPECT_TRUE(is_zero(cross(map.toward(on_face[c]), cone.corners[c])));
          EXPECT_NEAR(to_double(on_face[c].x), corner.x, 1e-9 * (1 + std::fabs(corner.x)));
          for (const IntegerVector& side : cone.inward) EXPECT_GE(dot_sign(side, cone.corners[c]), 0);
        }
      }
    }
  }
  EXPECT_GT(crossings, 100U);
}

TEST(ExactVisibilityMap3, ConesHaveNothingInCommonButWithThemselves) {
  const auto polygons = oracle::piercing_triangles(3, 20, 12, 9);
  const Occluders3 occluders(oracle::engine_polygons(polygons));
  const ExactVisibilityMap3 map(occluders, {Rational(1, 3), Rational(25, 7), 5});
  for (std::size_t k = 0; k < map.size(); ++k) {
    const auto whole = common_cone(map.cone(k), map.cone(k));
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->corners, map.cone(k).corners);
    for (std::size_t other = 0; other < k; ++other) EXPECT_FALSE(common_cone(map.cone(k), map.cone(other)));
  }
}

TEST(ExactCone3, LocatesInsideEdgesAndCorners) {
  const auto v = [](long x, long y, long z) { return IntegerVector{Integer(x), Integer(y), Integer(z)}; };
  const ExactCone3 octant{{v(0, 0, 1), v(1, 0, 0), v(0, 1, 0)}, {v(1, 0, 0), v(0, 1, 0), v(0, 0, 1)}};
  using Place = ExactCone3::Place;
  EXPECT_EQ(octant.locate(v(1, 1, 1)).place, Place::kInside);
  EXPECT_EQ(octant.locate(v(1, 1, -1)).place, Place::kOutside);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at_corner = octant.locate(octant.corners[k]);
    EXPECT_EQ(at_corner.place, Place::kAtCorner);
    EXPECT_EQ(at_corner.side, k);
    const auto on_edge = octant.locate(sum(octant.corners[k], octant.corners[(k + 1) % 3]));
    EXPECT_EQ(on_edge.place, Place::kOnEdge);
    EXPECT_EQ(on_edge.side, k);
    EXPECT_EQ(octant.locate(opposite(octant.corners[k])).place, Place::kOutside);
  }
}

}  // namespace
}  // namespace hottel::exact_visibility_map_test
