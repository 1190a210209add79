// Sums of weights over distances, held against those of one point after the other in more digits.
#include "geometry/space/unobstructed/distance_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hottel {
namespace {

TEST(SumOverFourthPowers, IsThatOfOnePointAfterTheOther) {
  std::mt19937_64 engine(12);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] {
    const double x = place(engine), y = place(engine);
    return LocalVector3<double>{x, y, place(engine)};
  };
  for (std::size_t count = 0; count < 40; ++count) {
    const LocalVector3<double> from = point() + LocalVector3<double>{4, 0, 0};
    WeightedPoints3 points;
    points.reserve(count);
    long double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const LocalVector3<double> at = point();
      const double weight = 1 + place(engine) / 2;
      points.add(at, weight);
      const long double x = from.x - at.x, y = from.y - at.y, z = from.z - at.z, square = x * x + y * y + z * z;
      sum += weight / (square * square);
    }
    EXPECT_NEAR(sum_over_fourth_powers(from, points), static_cast<double>(sum), 1e-14 * static_cast<double>(sum))
        << count;
  }
}

}  // namespace
}  // namespace hottel
