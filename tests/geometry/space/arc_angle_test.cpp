// Angles of arcs in plain arithmetic, held against those of the library in more digits.
#include "geometry/space/pieces/arc_angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace hottel {
namespace {

constexpr double kAllowed = 0x1p-51;

void expect_right(double sine, double cosine) {
  const long double angle = std::atan2(static_cast<long double>(sine), static_cast<long double>(cosine));
  EXPECT_LE(std::fabs(angle_of(sine, cosine) - angle), kAllowed * std::fabs(angle)) << sine << ' ' << cosine;
}

// (1) and (2)
TEST(AngleOf, IsWithinTwoUnitsOfTheAngleAndOdd) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi), exponent(-60, 60), within(-1, 1);
  for (int round = 0; round < 200000; ++round) {
    const double a = angle(engine), size = std::exp2(exponent(engine));
    expect_right(size * std::sin(a), size * std::cos(a));
    const double steep = std::exp2(exponent(engine)), sine = within(engine), cosine = steep * within(engine);
    expect_right(sine, cosine);
    EXPECT_EQ(angle_of(-sine, cosine), -angle_of(sine, cosine));
  }
}

// Where another octant begins, and where the angle is taken from another place.
TEST(AngleOf, IsRightAroundEveryEighthOfATurn) {
  for (const double ratio : {0.0, 0x1p-1000, 0x1p-53, 0.25, 0.5, 1.0, 2.0, 0x1p53})
    for (const double sine_sign : {1.0, -1.0})
      for (const double cosine_sign : {1.0, -1.0})
        for (int steps = -3; steps <= 3; ++steps) {
          double sine = ratio;
          for (int k = 0; k < std::abs(steps); ++k) sine = std::nextafter(sine, steps < 0 ? 0.0 : 4.0);
          if (sine > 0) expect_right(sine_sign * sine, cosine_sign);
        }
  EXPECT_EQ(angle_of(0, 1), 0);
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(1, 0), std::numbers::pi / 2);
  EXPECT_EQ(angle_of(0, -1), std::numbers::pi);
}

TEST(ArcAngle, IsOnTheKnownSideWhereTheSineIsLost) {
  constexpr double kHalf = std::numbers::pi, kLost = 1e-17;
  for (const double sine : {kLost, -kLost, 0.0}) {
    EXPECT_NEAR(arc_angle(sine, -1, 1), kHalf, 1e-15);
    EXPECT_NEAR(arc_angle(sine, -1, -1), -kHalf, 1e-15);
  }
  EXPECT_EQ(arc_angle(0.5, -0.5, 0), angle_of(0.5, -0.5));
  EXPECT_EQ(arc_angle(-0.5, 0.5, 1), angle_of(-0.5, 0.5));
}

}  // namespace
}  // namespace hottel
