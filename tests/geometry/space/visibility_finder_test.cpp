// Points found in the map of an eye, against every polygon asked in rationals.
#include "geometry/space/visibility/visibility_finder.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::visibility_finder_test {
namespace {

using oracle::SpacePoint;
using oracle::SpacePolygon;

enum class Way : unsigned char { kFree, kHidden, kTouched };

// Whether the segment crosses a polygon, or its outline.
Way way_through(const std::vector<SpacePolygon>& polygons, const SpacePoint& eye, const SpacePoint& point) {
  Way result = Way::kFree;
  for (const SpacePolygon& polygon : polygons) {
    const SpacePoint normal = normal_of(polygon), way = point - eye;
    const int at_eye = sgn(dot(normal, eye - polygon[0])), at_point = sgn(dot(normal, point - polygon[0]));
    if (at_eye == 0 || at_point != -at_eye) continue;
    bool is_inside = true, is_on_border = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const SpacePoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      const int sign = sgn(dot(cross(a - eye, b - eye), way)) * -at_eye;
      is_inside = is_inside && sign >= 0;
      is_on_border = is_on_border || sign == 0;
    }
    if (!is_inside) continue;
    if (!is_on_border) return Way::kHidden;
    result = Way::kTouched;
  }
  return result;
}

// The same where outlines are touched: some of the segments beside it are free.
bool sees_beside(const std::vector<SpacePolygon>& polygons, const SpacePoint& eye, const SpacePoint& point) {
  std::mt19937 engine(1);
  const auto little = [&engine]() -> mpq_class {
    return mpq_class(static_cast<long>(engine() % 2001) - 1000, 1000) / 1'000'000'000'000;
  };
  const mpq_class nearly = 1 - mpq_class(1, 1'000'000);
  for (int n = 0; n < 40; ++n) {
    const SpacePoint beside{eye.x + nearly * (point.x - eye.x) + little(),
                            eye.y + nearly * (point.y - eye.y) + little(),
                            eye.z + nearly * (point.z - eye.z) + little()};
    if (way_through(polygons, eye, beside) == Way::kFree) return true;
  }
  return false;
}

TEST(VisibilityFinder3, AgreesWithEveryPolygonAskedInRationals) {
  std::mt19937_64 engine(3);
  int seen = 0, hidden = 0, touched = 0;
  for (int n = 0; n < 24; ++n) {
    const auto seed = static_cast<std::uint64_t>(n);
    const auto polygons = n % 2 == 0 ? oracle::lattice_room(seed, 3, 1 + n % 3, 1 + n % 4 / 2, 2)
                                     : oracle::piercing_triangles(seed, 40, 12, 9);
    const Occluders3 occluders(oracle::engine_polygons(polygons));
    const long parts = n % 3 == 0 ? 1 : 7;
    const auto coordinate = [&engine](long denominator) -> Rational {
      return Rational(static_cast<long>(engine() % static_cast<std::uint64_t>(12 * denominator)), denominator);
    };
    for (int e = 0; e < 4; ++e) {
      Point3 eye{coordinate(parts), coordinate(parts), coordinate(parts)};
      for (Rational* value : {&eye.x, &eye.y, &eye.z}) value->canonicalize();
      const ExactVisibilityMap3 map(occluders, eye);
      const VisibilityFinder3 finder(map);
      const SpacePoint from{eye.x, eye.y, eye.z};
      for (int k = 0; k < 60; ++k) {
        Point3 point{coordinate(parts), coordinate(parts), coordinate(parts)};
        for (Rational* value : {&point.x, &point.y, &point.z}) value->canonicalize();
        const SpacePoint to{point.x, point.y, point.z};
        if (to == from) continue;
        const Way way = way_through(polygons, from, to);
        const bool expected = way == Way::kTouched ? sees_beside(polygons, from, to) : way == Way::kFree;
        EXPECT_EQ(finder.sees(point), expected)
            << "scene " << n << " from " << from.x << ' ' << from.y << ' ' << from.z << " to " << to.x << ' ' << to.y
            << ' ' << to.z << (way == Way::kTouched ? " touched" : "");
        touched += way == Way::kTouched;
        ++(expected ? seen : hidden);
      }
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(hidden, 500);
  EXPECT_GT(touched, 100);
}

// Two squares in z = 1 that share the edge x = 0, and what is beside them.
TEST(VisibilityFinder3, NothingSlipsThroughAnEdgeThatTwoPolygonsShare) {
  const Occluders3 occluders(
      {{{{-1, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 1}}, {}}, {{{0, -1, 1}, {1, -1, 1}, {1, 1, 1}, {0, 1, 1}}, {}}});
  const ExactVisibilityMap3 map(occluders, {0, 0, 0});
  const VisibilityFinder3 finder(map);
  EXPECT_FALSE(finder.sees({0, 0, 2}));
  EXPECT_TRUE(finder.sees({0, 2, 2}));  // beside their corner
  EXPECT_TRUE(finder.sees({2, 1, 2}));  // beside an edge
  EXPECT_TRUE(finder.sees({0, 0, 1}));  // on the edge itself
  EXPECT_TRUE(finder.sees({0, 0, Rational(1, 2)}));
  EXPECT_TRUE(finder.sees({0, 0, 0}));
  EXPECT_TRUE(finder.sees({0, 0, -3}));
}

}  // namespace
}  // namespace hottel::visibility_finder_test
