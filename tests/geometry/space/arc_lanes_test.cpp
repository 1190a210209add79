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
  std::vector<MovingVector3> corners;
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
    result.arcs.push_back({0, k, (k + 1) % count, k % 3 == 0 ? -1.0 : 1.0, 0});
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

// (1)
TEST(SumOfCloseArcs, IsThatOfOnePointAfterTheOtherBitForBit) {
  std::mt19937_64 engine(3);
  for (int round = 0; round < 2000; ++round) {
    const MovingArcs made = some_arcs(engine, 0.05);
    const Lanes3 offsets = offsets_in(engine);
    VectorLanes3 sums;
    Lanes3 rounding;
    ASSERT_TRUE(sum_of_close_arcs(made.arcs, made.corners, 0.25, offsets, sums, rounding));
    for (std::size_t k = 0; k < kLanes3; ++k) {
      double lost = 0;
      const Direction3 sum = sum_of_arcs<double>(
          made.arcs, units_at(made, 0.25, offsets[k]), [](std::uint32_t) { return Direction3{}; }, &lost);
      ASSERT_EQ((Direction3{sums.x[k], sums.y[k], sums.z[k]}), sum) << round << ' ' << k;
      ASSERT_EQ(rounding[k], lost) << round << ' ' << k;
    }
  }
}

// (2)
TEST(SumOfCloseArcs, IsNotToldWhereCornersAreFarFromEachOther) {
  std::mt19937_64 engine(4);
  MovingArcs made = some_arcs(engine, 0.01);
  made.corners[1].first = {-1, 0, 0, 1, 0};
  VectorLanes3 sums;
  Lanes3 rounding;
  EXPECT_FALSE(sum_of_close_arcs(made.arcs, made.corners, 0.25, offsets_in(engine), sums, rounding));
}

TEST(SumOfCloseArcs, IsNotToldWhereACornerIsZero) {
  std::mt19937_64 engine(5);
  for (const std::size_t zero : {0U, 1U}) {
    MovingArcs made = some_arcs(engine, 0.01);
    made.corners[zero] = {};
    VectorLanes3 sums;
    Lanes3 rounding;
    EXPECT_FALSE(sum_of_close_arcs(made.arcs, made.corners, 0.25, offsets_in(engine), sums, rounding));
  }
}

}  // namespace
}  // namespace hottel
