// Pairs of polygons with others between them, against rays and against quadrature, which know nothing of edges.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/comparison/space/pair_scene.h"
#include "tests/oracle/space/pair_quadrature.h"
#include "tests/oracle/space/pair_rays.h"
#include "tests/oracle/space/point_factor.h"
#include "tests/sanitizers.h"

namespace hottel::oracle::pair_integrator_against_oracle_test {
namespace {

constexpr double kParallel = 0.1998248956983873830416;  // unit squares at distance 1

FlatPair squares(std::vector<FlatPolygon> between) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, between};
}
const FlatPolygon kQuarter{{0, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0.5}, {0, 0.5, 0.5}};

TEST(PairRays, FindTheMeasureOfSquares) {
  for (const auto& [pair, measure] :
       {std::pair(squares({}), kParallel), std::pair(squares({kQuarter}), kParallel * 0.75)}) {
    const RayEstimate rays = exchange_by_rays(pair, 1, 1'000'000);
    EXPECT_LT(rays.standard_error, 2e-4);
    EXPECT_NEAR(rays.measure, measure, 5 * rays.standard_error);
  }
}

TEST(PairRays, AreNotHeldUpByWhatOnlyTouches) {
  const FlatPair open = squares({}),
                 touched = squares({{{1, 1, 0}, {1, 1, 1}, {2, 2, 1}}, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}}});
  EXPECT_EQ(exchange_by_rays(open, 1, 100'000).seen, exchange_by_rays(touched, 1, 100'000).seen);
}

TEST(PointFactor, IsLambertsBelowASquare) {
  // Below the corner of a parallel rectangle 1 x 2 at distance 1.
  const FlatPair pair{
      {{-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}}, {{0, 0, 1}, {0, 2, 1}, {1, 2, 1}, {1, 0, 1}}, {}};
  EXPECT_NEAR(PointFactor(pair)({0, 0, 0}), 0.1673750099143837674161, 1e-15);
  const FlatPair hidden{pair.i, pair.j, {{{-1, -1, 0.5}, {2, -1, 0.5}, {2, 3, 0.5}, {-1, 3, 0.5}}}};
  EXPECT_EQ(PointFactor(hidden)({0.1, 0.2, 0}), 0);
}

TEST(PairQuadrature, FindsTheMeasureOfSquares) {
  EXPECT_NEAR(exchange_by_quadrature(squares({}), 1e-10).measure, kParallel, 1e-10);
  EXPECT_NEAR(exchange_by_quadrature(squares({kQuarter}), 1e-10).measure, kParallel * 0.75, 1e-10);
}

// Random pairs, in general position and on a lattice.
class RandomPairs {
 public:
  explicit RandomPairs(std::uint64_t seed) : engine_(seed) {}

  std::vector<SpacePolygon> draw(int number) {
    std::vector<SpacePolygon> polygons{number % 3 == 0 ? triangle(0, 0) : square(0, number % 3 == 1),
                                       number % 2 == 0 ? square(1, false) : triangle(2, 4)};
    const int between = 1 + number % 3;
    while (static_cast<int>(polygons.size()) < 2 + between) polygons.push_back(triangle(1, 3));
    return polygons;
  }

 private:
  mpq_class number(long low, long high) {
    constexpr long kParts = 1 << 10;
    return mpq_class(low) +
           mpq_class(static_cast<long>(engine_() % static_cast<std::uint64_t>((high - low) * kParts))) / kParts;
  }

  SpacePolygon triangle(long low, long high) {
    for (;;) {
      SpacePolygon polygon;
      for (int k = 0; k < 3; ++k)
        polygon.push_back({number(0, 4), number(0, 4), low == high ? mpq_class(low) : number(low, high)});
      const SpacePoint normal = normal_of(polygon);
      if (abs(normal.x) + abs(normal.y) + abs(normal.z) < 1) continue;
      if (low == high ? normal.z < 0 : (low == 2 && normal.z > 0)) std::reverse(polygon.begin(), polygon.end());
      return polygon;
    }
  }

  // The floor, or the ceiling, or the wall at x = 0.
  static SpacePolygon square(int which, bool is_small) {
    if (which == 0 && is_small) return {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
    if (which == 0) return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    return {{0, 0, 4}, {0, 4, 4}, {4, 4, 4}, {4, 0, 4}};
  }

  std::mt19937_64 engine_;
};

constexpr int kPairs = kHasAddressSanitizer ? 20 : 120;

TEST(PairMeasures, AreThoseOfQuadratureAndRays) {
  RandomPairs pairs(1);
  double worst = 0, worst_by_rays = 0;
  int mixed = 0;
  for (int n = 0; n < kPairs; ++n) {
    const std::vector<SpacePolygon> polygons = pairs.draw(n);
    const PairScene3 scene(polygons);
    const PairResult3 m = scene.measure(scene.patch(0), scene.patch(1));
    ASSERT_EQ(m.problem, "") << n;
    mixed += m.sight == PairVisibility3::kMixed ? 1 : 0;
    const FlatPair pair = first_pair(polygons);
    const double whole = std::min(area(pair.i), area(pair.j));
    const QuadratureResult there = exchange_by_quadrature(pair, 1e-7, 200'000);
    const QuadratureResult back = exchange_by_quadrature(pair.reversed(), 1e-7, 200'000);
    const QuadratureResult& better = there.error < back.error ? there : back;
    EXPECT_NEAR(m.measure, better.measure, 10 * better.error + 1e-9 * whole) << n;
    const RayEstimate rays = exchange_by_rays(pair, static_cast<std::uint64_t>(n), 64'000);
    EXPECT_NEAR(m.measure, rays.measure, 6 * rays.standard_error) << n;
    worst = std::max(worst, std::fabs(m.measure - better.measure) / whole);
    worst_by_rays = std::max(worst_by_rays, std::fabs(m.measure - rays.measure) / rays.standard_error);
  }
  fmt::print("{} pairs, {} with something between; off quadrature by {:.2g} of the area, off rays by {:.1f} errors\n",
             kPairs, mixed, worst, worst_by_rays);
  EXPECT_GT(mixed, kPairs / 2);
}

}  // namespace
}  // namespace hottel::oracle::pair_integrator_against_oracle_test
