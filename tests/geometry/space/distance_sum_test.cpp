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
  for (const std::size_t count : {0, 1, 2, 3, 4, 5, 7, 8, 31, 64, 127, 128, 129, 131, 132, 255, 256, 300}) {
    const LocalVector3<double> from = point() + LocalVector3<double>{4, 0, 0};
    WeightedPoints3 points;
    long double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const LocalVector3<double> at = point();
      const double weight = 1 + place(engine) / 2;
      points.x.push_back(at.x);
      points.y.push_back(at.y);
      points.z.push_back(at.z);
      points.weight.push_back(weight);
      const long double x = from.x - at.x, y = from.y - at.y, z = from.z - at.z, square = x * x + y * y + z * z;
      sum += weight / (square * square);
    }
    EXPECT_NEAR(sum_over_fourth_powers(from, points), static_cast<double>(sum), 1e-14 * static_cast<double>(sum))
        << count;
  }
}

TEST(WeightedPoints, AreThoseOfOneNodeAfterTheOther) {
  std::mt19937_64 engine(13);
  std::uniform_real_distribution<double> place(0, 1);
  const auto approximation = [&] {
    const double value = place(engine);
    return Approximation<double>{value, 1e-15 * place(engine)};
  };
  for (int n = 2; n <= 10; ++n)
    for (const int m : {2, 3, 6, 7, 10}) {
      WeightedPoints3 points;
      double off = 0, expected_off = 0;
      std::size_t at = 0;
      for (int c = 0; c < 2; ++c) {
        WeightedCell3 cell;
        for (std::size_t k = 0; k < 4; ++k) {
          const double x = place(engine), y = place(engine);
          cell.corner[k] = {x, y, place(engine)};
          cell.height[k] = approximation();
          cell.density[k] = approximation();
        }
        const LegendreRule<double>&along = legendre_rule<double>(n), &across = legendre_rule<double>(m);
        points.add(cell, along, across, off);
        for (std::size_t a = 0; a < along.node.size(); ++a)
          for (std::size_t b = 0; b < across.node.size(); ++b, ++at) {
            const double s = along.node[a], t = across.node[b];
            LocalVector3<double> point;
            double height = 0, density = 0;
            const double shares[] = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
            for (std::size_t k = 0; k < 4; ++k) {
              point = point + shares[k] * cell.corner[k];
              height += shares[k] * cell.height[k].value;
              density += shares[k] * cell.density[k].value;
            }
            const double rules = along.weight[a] * across.weight[b];
            EXPECT_NEAR(points.x[at], point.x, 1e-15);
            EXPECT_NEAR(points.y[at], point.y, 1e-15);
            EXPECT_NEAR(points.z[at], point.z, 1e-15);
            EXPECT_NEAR(points.weight[at], rules * height * density, 1e-15 * rules);
            for (std::size_t k = 0; k < 4; ++k)
              expected_off += rules * shares[k] * (height * cell.density[k].error + density * cell.height[k].error);
          }
      }
      EXPECT_EQ(points.size(), at);
      EXPECT_GE(off, expected_off);
      EXPECT_LE(off, expected_off + 1e-14);
    }
}

}  // namespace
}  // namespace hottel
