#include "geometry/space/visibility/visibility_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "tests/comparison/space/map_comparison.h"
#include "tests/oracle/space/random_polygons.h"

namespace hottel::visibility_map_test {
namespace {

using oracle::SpacePolygon;
using std::numbers::pi;

constexpr double kClosure = 5e-15;

Rational ratio(long p, long q) { return Rational(p) / q; }

Occluders3 occluders_of(const std::vector<SpacePolygon>& polygons) {
  return Occluders3(oracle::engine_polygons(polygons));
}

double share_of(const VisibilityMap3& map, std::uint32_t surface) {
  for (const VisibilityMap3::Share& share : map.shares)
    if (share.face.surface == surface) return share.fraction;
  return 0;
}

// The map from a point, which the darts find nothing wrong with.
VisibilityMap3 tested_map(const std::vector<SpacePolygon>& polygons, const Look3& look, int darts = 300) {
  VisibilityMap3 map = map_from(occluders_of(polygons), look);
  oracle::DartCounts counts;
  EXPECT_EQ(oracle::dart_disagreement(polygons, look, map, 1, darts, counts), "");
  return map;
}

void expect_same_view(const VisibilityMap3& a, const VisibilityMap3& b) {
  ASSERT_EQ(a.corners.size(), b.corners.size());
  ASSERT_EQ(a.fragments.size(), b.fragments.size());
  ASSERT_EQ(a.shares.size(), b.shares.size());
  for (std::size_t k = 0; k < a.corners.size(); ++k) {
    EXPECT_EQ(a.corners[k].direction, b.corners[k].direction);
    EXPECT_EQ(a.corners[k].side, b.corners[k].side);
  }
  for (std::size_t k = 0; k < a.fragments.size(); ++k) EXPECT_EQ(a.fragments[k].face, b.fragments[k].face);
  for (std::size_t k = 0; k < a.shares.size(); ++k) EXPECT_EQ(a.shares[k].fraction, b.shares[k].fraction);
  EXPECT_EQ(a.sky_fraction, b.sky_fraction);
}

// By symmetry each wall takes a sixth.
TEST(VisibilityMap3, ACubeFromItsCentreIsSeenInSixths) {
  const VisibilityMap3 map = tested_map(oracle::room_of_walls({0, 0, 0}, {2, 2, 2}, 1), {{1, 1, 1}, {}});
  ASSERT_EQ(map.shares.size(), 6u);
  for (const VisibilityMap3::Share& share : map.shares) {
    EXPECT_NEAR(share.fraction, 1.0 / 6, 1e-16);
    EXPECT_FALSE(share.face.is_back);
  }
  EXPECT_NEAR(map.sky_fraction, 0, kClosure);
}

// From below a corner of a rectangle a x b at height d: the solid angle is atan(a b / (d sqrt(a^2 + b^2 + d^2))), and
// the view factor from a parallel surface (Howell C-3) 1/(2 pi) (X/sqrt(1+X^2) atan(Y/sqrt(1+X^2)) + the same with X
// and Y exchanged), X = a/d, Y = b/d.
TEST(VisibilityMap3, ARectangleIsSeenAsInClosedForm) {
  for (const auto& [a, b, d] : {std::tuple(1, 1, 1), std::tuple(3, 2, 1), std::tuple(1, 5, 7), std::tuple(100, 1, 3)}) {
    const std::vector<SpacePolygon> polygons{{{0, 0, d}, {0, b, d}, {a, b, d}, {a, 0, d}}};
    const VisibilityMap3 map = tested_map(polygons, {{0, 0, 0}, Point3{0, 0, 9}});
    ASSERT_EQ(map.shares.size(), 1u);
    const double x = static_cast<double>(a) / d, y = static_cast<double>(b) / d;
    EXPECT_NEAR(map.shares[0].fraction, std::atan(x * y / std::sqrt(x * x + y * y + 1)) / (4 * pi), 2e-16);
    const double half = [](double p, double q) { return p / std::hypot(1, p) * std::atan(q / std::hypot(1, p)); }(x, y);
    const double other = y / std::hypot(1, y) * std::atan(x / std::hypot(1, y));
    EXPECT_NEAR(map.shares[0].factor, (half + other) / (2 * pi), 2e-16);
    EXPECT_NEAR(map.shares[0].factor + map.sky_factor, 1, 1e-15);
    EXPECT_NEAR(map.shares[0].fraction + map.sky_fraction, 0.5, 1e-15);
    EXPECT_EQ(map_from(occluders_of(polygons), {{0, 0, 2 * d}, {}}).shares[0].face, (Face{0, true}));
  }
}

TEST(VisibilityMap3, CornersLieWhereTheFaceIsMet) {
  const auto polygons = oracle::lattice_room(3, 2, 1, 1, 2);
  const Look3 look{{ratio(17, 2), ratio(22, 7), ratio(1, 2)}, {}};
  const VisibilityMap3 map = tested_map(polygons, look);
  for (const VisibilityMap3::Fragment& fragment : map.fragments) {
    const SpacePolygon& polygon = polygons[fragment.face.surface];
    const oracle::SpacePoint n = oracle::normal_of(polygon);
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
      const VisibilityMap3::Corner& corner = map.corners[c];
      const double height = to_double(oracle::dot(n, polygon[0]));
      EXPECT_NEAR(to_double(n.x) * corner.x + to_double(n.y) * corner.y + to_double(n.z) * corner.z, height, 1e-12);
      const double x = corner.x - to_double(look.eye.x), y = corner.y - to_double(look.eye.y),
                   z = corner.z - to_double(look.eye.z), length = std::sqrt(x * x + y * y + z * z);
      EXPECT_NEAR(x, length * corner.direction.x, 1e-13);
      EXPECT_NEAR(y, length * corner.direction.y, 1e-13);
      EXPECT_NEAR(z, length * corner.direction.z, 1e-13);
    }
  }
}

// On a wall one sees the half space before it; in the line of two walls a quarter, in a corner an eighth: what lies in
// the planes of the eye has no solid angle, and outside is the sky.
TEST(VisibilityMap3, OnWallsInEdgesAndCornersOpenSetsCount) {
  const auto room = oracle::room_of_walls({0, 0, 0}, {4, 4, 4}, 2);
  for (const auto& [eye, sky] :
       {std::pair(Point3{1, 1, 0}, 0.5), std::pair(Point3{2, 1, 0}, 0.5), std::pair(Point3{2, 2, 0}, 0.5),
        std::pair(Point3{0, 1, 0}, 0.75), std::pair(Point3{0, 2, 0}, 0.75), std::pair(Point3{0, 0, 0}, 0.875)})
    EXPECT_NEAR(tested_map(room, {eye, {}}).sky_fraction, sky, kClosure);
  const VisibilityMap3 floor = tested_map(room, {{1, 1, 0}, Point3{0, 0, 1}});
  EXPECT_NEAR(floor.sky_factor, 0, kClosure);
  EXPECT_NEAR(floor.sky_fraction, 0, kClosure);
  // Half of what leaves obliquely goes through the floor: the factor of the half sphere above it is (1 + cos 45)/2.
  const VisibilityMap3 oblique = tested_map(room, {{1, 1, 0}, Point3{1, 0, 1}});
  EXPECT_NEAR(oblique.sky_factor, 0.5 - std::sqrt(0.125), kClosure);
}

// At a corner, on an edge, on a face of a box, and in lines of many edges.
TEST(VisibilityMap3, EyesOnBoxesSeeAllAroundThem) {
  const auto polygons = oracle::lattice_room(11, 3, 1, 2, 3);
  ASSERT_GT(polygons.size(), 200u);
  for (std::size_t s = 54; s < polygons.size(); s += 37) {
    const SpacePolygon& p = polygons[s];
    const auto middle = [](const oracle::SpacePoint& a, const oracle::SpacePoint& b) {
      return Point3{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    };
    tested_map(polygons, {{p[0].x, p[0].y, p[0].z}, {}}, 60);
    tested_map(polygons, {middle(p[0], p[1]), {}}, 60);
    tested_map(polygons, {middle(p[0], p[2]), {}}, 60);
    tested_map(polygons, {{p[0].x * 2 - p[1].x, p[0].y * 2 - p[1].y, p[0].z * 2 - p[1].z}, {}}, 60);
  }
}

TEST(VisibilityMap3, ClosedRoomsAreSeenWhole) {
  const auto polygons = oracle::lattice_room(5, 3, 1, 2, 4);
  const Occluders3 occluders = occluders_of(polygons);
  for (int k = 0; k < 40; ++k) {
    const Point3 eye{ratio(k * 7 + 1, 23), ratio(k * 5 % 61 + 1, 7), ratio(k * 11 % 50 + 1, 6)};
    const VisibilityMap3 map = map_from(occluders, {eye, k % 2 == 0 ? std::optional<Point3>({1, k, 3}) : std::nullopt});
    EXPECT_LE(std::fabs(map.sky_fraction), kClosure);
    EXPECT_LE(std::fabs(map.sky_factor), kClosure);
  }
}

TEST(VisibilityMap3, DoesNotDependOnPlaceAndUnit) {
  const auto polygons = oracle::lattice_room(7, 3, 1, 1, 3);
  const Point3 eye{ratio(17, 4), ratio(9, 2), ratio(39, 8)};
  const VisibilityMap3 map = map_from(occluders_of(polygons), {eye, {}});
  const Rational third = ratio(1, 3), billion = 1'000'000'000;
  for (const Rational& scale : {Rational(1), scaled_by_power_of_two(1, -60), scaled_by_power_of_two(1, 40), third})
    for (const Rational& offset : {Rational(0), billion, Rational(billion + third)}) {
      const auto other = oracle::moved(polygons, scale, {offset, -offset, 2 * offset});
      const Point3 moved{eye.x * scale + offset, eye.y * scale - offset, eye.z * scale + 2 * offset};
      expect_same_view(map, map_from(occluders_of(other), {moved, {}}));
    }
}

TEST(VisibilityMap3, AxesAreAlike) {
  auto polygons = oracle::piercing_triangles(9, 60, 100, 40);
  const Point3 eye{ratio(151, 3), 51, 49};
  const VisibilityMap3 map = map_from(occluders_of(polygons), {eye, {}});
  for (SpacePolygon& polygon : polygons)
    for (oracle::SpacePoint& p : polygon) p = {p.y, p.z, p.x};
  const VisibilityMap3 turned = map_from(occluders_of(polygons), {{eye.y, eye.z, eye.x}, {}});
  ASSERT_EQ(map.shares.size(), turned.shares.size());
  for (std::size_t k = 0; k < map.shares.size(); ++k) {
    EXPECT_EQ(map.shares[k].face, turned.shares[k].face);
    EXPECT_NEAR(map.shares[k].fraction, turned.shares[k].fraction, 1e-15);
  }
}

TEST(VisibilityMap3, IsAdditiveWhenAPolygonIsSplit) {
  auto polygons = oracle::lattice_room(13, 2, 1, 1, 1);
  const Look3 look{{ratio(9, 2), ratio(31, 7), ratio(41, 9)}, Point3{1, 2, -3}};
  const VisibilityMap3 whole = map_from(occluders_of(polygons), look);
  const std::size_t count = polygons.size();
  for (std::size_t s = 0; s < count; ++s) {
    const SpacePolygon p = polygons[s];
    polygons[s] = {p[0], p[1], p[2]};
    polygons.push_back({p[0], p[2], p[3]});
  }
  const VisibilityMap3 split = tested_map(polygons, look);
  const auto factor_of = [](const VisibilityMap3& map, std::uint32_t surface) {
    for (const VisibilityMap3::Share& share : map.shares)
      if (share.face.surface == surface) return share.factor;
    return 0.0;
  };
  for (std::uint32_t s = 0; s < count; ++s) {
    const auto other = static_cast<std::uint32_t>(count + s);
    EXPECT_NEAR(share_of(whole, s), share_of(split, s) + share_of(split, other), 1e-15);
    EXPECT_NEAR(factor_of(whole, s), factor_of(split, s) + factor_of(split, other), 1e-15);
  }
}

TEST(VisibilityMap3, TheFilterDecidesAsIntegersDo) {
  for (const bool is_room : {true, false}) {
    const auto polygons = is_room ? oracle::lattice_room(17, 3, 1, 1, 3) : oracle::piercing_triangles(17, 80, 60, 25);
    const Occluders3 occluders = occluders_of(polygons);
    for (const Point3& eye : {Point3{4, 4, 4}, Point3{ratio(13, 3), ratio(9, 2), 5}, Point3{8, 4, ratio(1, 7)}}) {
      const VisibilityMap3 filtered = map_from(occluders, {eye, Point3{1, 1, 5}});
      const VisibilityMap3 exact = map_from(occluders, {eye, Point3{1, 1, 5}, true});
      expect_same_view(filtered, exact);
      EXPECT_GT(filtered.signs.by_tier[0], filtered.signs.by_tier[2]);
      EXPECT_GT(exact.signs.by_tier[2], exact.signs.by_tier[0]);
    }
  }
}

// Two triangles of one quadrangle, which a corner that is 2^-60 off makes pierce each other's plane, and two whole
// ones that pierce each other at an angle of 2^-60.
TEST(VisibilityMap3, TwinsThatAreNearlyInOnePlaneAreToldApart) {
  const Rational tiny = scaled_by_power_of_two(1, -60);
  const std::vector<SpacePolygon> joined{{{0, 0, 3}, {4, 0, 3}, {4, 4, 3}}, {{0, 0, 3}, {4, 4, 3}, {0, 4, 3 + tiny}}};
  const VisibilityMap3 pair = tested_map(joined, {{2, 1, 0}, {}});
  EXPECT_EQ(pair.fragments.size(), 2u);
  const std::vector<SpacePolygon> piercing{{{0, 0, 3}, {4, 0, 3}, {4, 4, 3}, {0, 4, 3}},
                                           {{0, 0, 3 - tiny}, {4, 0, 3 + tiny}, {4, 4, 3 + tiny}, {0, 4, 3 - tiny}}};
  const VisibilityMap3 map = tested_map(piercing, {{2, 2, 0}, {}}, 2000);
  ASSERT_EQ(map.shares.size(), 2u);
  EXPECT_NEAR(map.shares[0].fraction, map.shares[1].fraction, 1e-15);
  EXPECT_GT(map.signs.by_tier[2], 0u);
}

// A slit of 2^-60: its light is seen, neither lost nor enlarged.
TEST(VisibilityMap3, ASlitLetsThroughWhatItLetsThrough) {
  const Rational tiny = scaled_by_power_of_two(1, -60);
  const std::vector<SpacePolygon> polygons{{{-9, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-9, 1, 1}},
                                           {{tiny, -1, 1}, {9, -1, 1}, {9, 1, 1}, {tiny, 1, 1}},
                                           {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  const VisibilityMap3 map = tested_map(polygons, {{0, 0, 0}, {}});
  ASSERT_EQ(map.shares.size(), 3u);
  // As wide as the slit and from -1/2 to 1/2 in its plane: 2^-60 times 2 (1/2) / sqrt(1 + 1/4), over the sphere.
  EXPECT_NEAR(map.shares[2].fraction * 0x1p60, 1 / std::sqrt(1.25) / (4 * pi), 1e-12);
  const std::vector<SpacePolygon> closed{polygons[0], {{0, -1, 1}, {9, -1, 1}, {9, 1, 1}, {0, 1, 1}}, polygons[2]};
  EXPECT_EQ(tested_map(closed, {{0, 0, 0}, {}}).shares.size(), 2u);
}

TEST(VisibilityMap3, EyesNextToAWallSeeAllOfTheRoom) {
  const auto room = oracle::room_of_walls({0, 0, 0}, {1, 1, 1}, 2);
  for (const long exponent : {-30, -60, -1000, -3000}) {
    const Rational tiny = scaled_by_power_of_two(1, exponent);
    EXPECT_NEAR(tested_map(room, {{ratio(1, 3), ratio(2, 5), tiny}, {}}, 50).sky_fraction, 0, kClosure);
    EXPECT_NEAR(tested_map(room, {{tiny, ratio(1, 2), tiny}, Point3{0, 0, 1}}, 50).sky_factor, 0, kClosure);
  }
}

// Next to an edge of a large square, h p inside of it and h q above: in the limit it takes the wedge between the way to
// the edge and its plane. What two ends of the edge tell of that plane is nothing.
TEST(VisibilityMap3, EyesNextToAnEdgeSeeAWedge) {
  const std::vector<SpacePolygon> polygons{{{-1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {-1, 2, 0}}};
  for (int k = 20; k <= 300; k += 14)
    for (const auto& [p, q] : {std::pair(1, 2), std::pair(-1, 2), std::pair(0, 1), std::pair(5, 1), std::pair(-7, 3)})
      for (const Rational& x : {ratio(0, 1), ratio(1, 7), ratio(-9, 10)}) {
        const Rational h = Rational(1) / (Integer(1) << k);
        const VisibilityMap3 map = tested_map(polygons, {{x, p * h, q * h}, Point3{0, 0, -1}});
        ASSERT_EQ(map.shares.size(), 1u);
        const double far = std::ldexp(100.0, -k);
        EXPECT_NEAR(map.shares[0].fraction, (pi - std::atan2(q, p)) / (2 * pi), far + 1e-15)
            << k << ' ' << p << ' ' << q;
        EXPECT_NEAR(map.shares[0].factor, (1 + p / std::hypot(p, q)) / 2, far + 1e-15) << k << ' ' << p << ' ' << q;
      }
}

// The same above the inside of a polygon, whose corners are then nearly on the horizon: half of the sphere.
TEST(VisibilityMap3, EyesNextToAPolygonSeeHalfOfTheSphere) {
  const std::vector<SpacePolygon> polygons{{{0, 0, 0}, {8, 0, 2}, {3, 8, 5}}};
  for (int k = 30; k <= 200; k += 17)
    for (long a = 1; a < 8; ++a)
      for (long b = 1; a + b < 8; ++b) {
        const Point3 eye{ratio(8 * a + 3 * b, 8), ratio(8 * b, 8),
                         ratio(2 * a + 5 * b, 8) + 1 / Rational(Integer(1) << k)};
        const VisibilityMap3 map = tested_map(polygons, {eye, {}}, 20);
        EXPECT_NEAR(share_of(map, 0), 0.5, std::ldexp(100.0, -k) + 1e-15) << k << ' ' << a << ' ' << b;
      }
}

TEST(VisibilityMap3, DoesNotDependOnThreads) {
  const Occluders3 occluders = occluders_of(oracle::lattice_room(19, 3, 1, 1, 3));
  const auto maps = [&occluders](int threads) {
    const ThreadLimit limit(threads);
    std::vector<VisibilityMap3> result(24);
    parallel_for(result.size(), [&](std::size_t k) {
      result[k] = map_from(occluders, {{ratio(static_cast<long>(k) + 1, 3), 5, ratio(14, 3)}, {}});
    });
    return result;
  };
  const auto one = maps(1), many = maps(4);
  for (std::size_t k = 0; k < one.size(); ++k) {
    expect_same_view(one[k], many[k]);
    EXPECT_EQ(one[k].signs, many[k].signs);
  }
}

TEST(VisibilityMap3, NothingIsSeenWhereThereIsNothing) {
  const VisibilityMap3 map = map_from(Occluders3({}), {{1, 2, 3}, {}});
  EXPECT_THAT(map.fragments, testing::IsEmpty());
  EXPECT_EQ(map.sky_fraction, 1);
  EXPECT_THROW(map_from(Occluders3({}), {{1, 2, 3}, Point3{0, 0, 0}}), ContractViolation);
}

}  // namespace
}  // namespace hottel::visibility_map_test
