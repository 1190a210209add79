// Maps of what points see against the brute force: darts, each decided in rationals.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/comparison/space/map_comparison.h"
#include "tests/oracle/space/nearest_polygon.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::oracle::visibility_map_against_oracle_test {
namespace {

constexpr int kScenes = 24;
constexpr int kEyes = 8;
constexpr int kDarts = 150;

TEST(RayCaster, MeetsTheNearest) {
  const std::vector<SpacePolygon> polygons{{{0, 0, 2}, {2, 0, 2}, {0, 2, 2}}, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  const RayCaster caster(polygons, {0, 0, 0});
  EXPECT_EQ(caster({1, 1, 4}).polygon, 1);
  EXPECT_FALSE(caster({1, 1, 2}).is_plain);
  EXPECT_EQ(caster({-1, -1, 3}).polygon, NearestPolygon::kNoPolygon);
  EXPECT_EQ(caster({-1, -1, -4}).polygon, NearestPolygon::kNoPolygon);
}

TEST(Darts, SeeAMapThatIsWrong) {
  const auto polygons = lattice_room(1, 2, 1, 1, 1);
  const Look3 look{{Rational(17) / 4, Rational(9) / 2, 5}, {}};
  VisibilityMap3 map = map_from(Occluders3(engine_polygons(polygons)), look);
  DartCounts counts;
  ASSERT_EQ(dart_disagreement(polygons, look, map, 1, 500, counts), "");
  map.fragments[0].face.is_back = !map.fragments[0].face.is_back;
  EXPECT_NE(dart_disagreement(polygons, look, map, 1, 500, counts), "");
  map.fragments.erase(map.fragments.begin());
  EXPECT_NE(dart_disagreement(polygons, look, map, 1, 500, counts), "");
}

// Boxes that touch, and triangles that pierce each other in a room; eyes on the lattice and anywhere.
TEST(Darts, FindTheFragmentOfWhatIsMetFirst) {
  std::mt19937_64 engine(1);
  DartCounts counts;
  for (int n = 0; n < kScenes; ++n) {
    const auto seed = static_cast<std::uint64_t>(n);
    auto polygons =
        n % 2 == 0 ? lattice_room(seed, 3, 1 + n % 3, 1 + n % 4 / 2, 2) : piercing_triangles(seed, 40, 12, 9);
    if (n % 4 == 3) polygons = moved(polygons, mpq_class(1) / 3, {1'000'000'000, mpq_class(1) / 7, 0});
    const Occluders3 occluders(engine_polygons(polygons));
    for (int e = 0; e < kEyes; ++e) {
      const auto coordinate = [&engine, e]() -> Rational {
        return Rational(static_cast<long>(engine() % 130)) / (e % 2 == 0 ? 10 : 1 + e);
      };
      Look3 look{{coordinate(), coordinate(), coordinate()}, {}};
      if (e % 3 == 0) look.normal = Point3{coordinate() - 6, coordinate() - 7, 1};
      if (n % 4 == 3) look.eye = {look.eye.x / 3 + 1'000'000'000, look.eye.y / 3 + Rational(1) / 7, look.eye.z / 3};
      const VisibilityMap3 map = map_from(occluders, look);
      ASSERT_EQ(dart_disagreement(polygons, look, map, seed * 100 + e, kDarts, counts), "")
          << "scene " << n << ", eye " << e;
    }
  }
  fmt::print("{} darts compared, {} through an edge\n", counts.darts, counts.ambiguous);
  EXPECT_GT(counts.darts, 20 * counts.ambiguous);
}

}  // namespace
}  // namespace hottel::oracle::visibility_map_against_oracle_test
