#include "geometry/space/integrals/arc_lanes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace hottel {
namespace {

// Arcs around a direction, between corners that move, at most `spread` from each other.
struct MovingArcs {
  std::vector<SeenArc3> arcs;
  std::vector<MovingVector3> corners, planes;
};
MovingArcs some_arcs(std::mt19937_64& engine, double spread) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto vector = [&](double size) {
    return Direction3{between(-size, size), between(-size, size), between(-size, size)};
  };
  MovingArcs result;
  const Direction3 middle = vector(1) + Direction3{2, 0, 0};
  const auto count = static_cast<std::uint32_t>(3 + engine() % 6);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Direction3 at = middle + vector(spread);
    result.corners.push_back({{at.x, at.y, at.z, 4, 0}, vector(spread), vector(spread / 4), {4, 1, 1}, between(0, 1)});
    result.arcs.push_back({k % 2, k, (k + 1) % count, k % 3 == 0 ? -1.0 : 1.0, static_cast<int>(k % 3) - 1});
  }
  for (int plane = 0; plane < 2; ++plane) {
    const Direction3 normal = vector(1);
    result.planes.push_back({{normal.x, normal.y, normal.z, 1, 0}, vector(0.1), {}, {1, 1, 0}, between(0, 1)});
  }
  return result;
}

Lanes3 offsets_in(std::mt19937_64& engine) {
  Lanes3 result;
  for (double& offset : result) offset = std::uniform_real_distribution<double>(0, 0.5)(engine);
  return result;
}

std::vector<Direction3> units_at(const MovingArcs& arcs, double from, double offset) {
  std::vector<Direction3> result;
  for (const MovingVector3& corner : arcs.corners) result.push_back(unit_or_zero<double>(corner.at(from, offset)));
  return result;
}

void expect_same(const MovingArcs& made, const Lanes3& offsets, const char* what) {
  VectorLanes3 sums;
  Lanes3 rounding;
  ASSERT_TRUE(sum_of_arcs_in_lanes(made.arcs, made.corners, made.planes, 0.25, offsets, sums, rounding)) << what;
  for (std::size_t k = 0; k < kLanes3; ++k) {
    double lost = 0;
    const auto normal_of = [&](std::uint32_t plane) { return made.planes[plane].at(0.25, offsets[k]); };
    const Direction3 sum = sum_of_arcs<double>(made.arcs, units_at(made, 0.25, offsets[k]), normal_of, &lost);
    ASSERT_EQ((Direction3{sums.x[k], sums.y[k], sums.z[k]}), sum) << what << ' ' << k;
    ASSERT_EQ(rounding[k], lost) << what << ' ' << k;
  }
}

// (1)
TEST(SumOfArcsInLanes, IsThatOfOnePointAfterTheOtherBitForBit) {
  std::mt19937_64 engine(3);
  for (int round = 0; round < 2000; ++round) {
    const MovingArcs made = some_arcs(engine, 0.05);
    expect_same(made, offsets_in(engine), "close");
    MovingArcs wide = made;
    wide.corners[1].first = {-1, 0.5, 0.25, 1, 0};
    wide.corners[2].first = {0.25, 3, -1, 3, 0};
    expect_same(wide, offsets_in(engine), "not close");
  }
}

// (1)
TEST(SumOfArcsInLanes, IsThatOfEachPointWhereCornersAreCloseAtSomePointsAlone) {
  std::mt19937_64 engine(4);
  for (int round = 0; round < 500; ++round) {
    MovingArcs made = some_arcs(engine, 0.01);
    made.corners[1].second = {0, 8, 0};
    made.corners[1].base = 0.25;
    Lanes3 offsets = offsets_in(engine);
    for (std::size_t k = 0; k < kLanes3; k += 3) offsets[k] = 0;
    expect_same(made, offsets, "close at some points");
  }
}

// (2)
TEST(SumOfArcsInLanes, IsNotToldWhereANormalIsZeroThatIsNeeded) {
  std::mt19937_64 engine(6);
  MovingArcs made = some_arcs(engine, 0.05);
  made.planes[1] = {};
  expect_same(made, offsets_in(engine), "close");
  made.corners[1].first = {-1, 0.5, 0.25, 1, 0};
  VectorLanes3 sums;
  Lanes3 rounding;
  EXPECT_FALSE(sum_of_arcs_in_lanes(made.arcs, made.corners, made.planes, 0.25, offsets_in(engine), sums, rounding));
}

TEST(SumOfArcsInLanes, IsNotToldWhereACornerIsZero) {
  std::mt19937_64 engine(5);
  for (const std::size_t zero : {0U, 1U}) {
    MovingArcs made = some_arcs(engine, 0.01);
    made.corners[zero] = {};
    VectorLanes3 sums;
    Lanes3 rounding;
    EXPECT_FALSE(sum_of_arcs_in_lanes(made.arcs, made.corners, made.planes, 0.25, offsets_in(engine), sums, rounding));
  }
}

}  // namespace
}  // namespace hottel
