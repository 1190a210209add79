// Beams in the plane: directions of any length, borders and right angles exactly, falloffs of any size.
#include "solver/plane/light/beam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "kernel/exact_double.h"

namespace hottel::beam_test {
namespace {

using WideNumber = boost::multiprecision::cpp_bin_float_100;

Rational exactly(const std::string& text) { return *parse_rational(text); }

Light beam_light(const Rational& focus, const Rational& falloff) {
  Light light;
  light.type = LightType::kSpot;
  light.focus = focus;
  light.falloff = falloff;
  return light;
}

Beam2 beam_along(const Point2& direction, const Rational& focus, const Rational& falloff, const Rational& turned = 0) {
  LightPlace2 place;
  place.direction = direction;
  place.turned = turned;
  return Beam2(beam_light(focus, falloff), place);
}

Point2 scaled(const Point2& p, const Rational& factor) { return {p.x * factor, p.y * factor}; }

double intensity(const Beam2& beam, const Point2& direction) {
  return beam.intensity(to_double(direction.x), to_double(direction.y), [&] { return direction; });
}

const std::vector<std::string> kLengths{"1",     "1e300",  "1e-300", "1e308",  "1e-330",
                                        "1e400", "1e-400", "1e4000", "1e-4000"};

// The axis and what is asked for may have any length.
TEST(Beam2, DirectionsAreOfAnyLength) {
  const Point2 axis{3, 4}, inside{2, 3}, beside{-4, 3}, below{1, -1}, at_border{4, 3};
  for (const Rational& falloff : {Rational(0), Rational(1, 2), Rational(3)})
    for (const Rational& turned : {Rational(0), Rational(77, 3)}) {
      const Beam2 plain = beam_along(axis, 50, falloff, turned);
      for (const std::string& of_axis : kLengths) {
        const Beam2 beam = beam_along(scaled(axis, exactly(of_axis)), 50, falloff, turned);
        for (const std::string& of_way : kLengths)
          for (const Point2& way : {inside, beside, below, at_border}) {
            const Point2 longer = scaled(way, exactly(of_way));
            EXPECT_EQ(beam.contains(longer), plain.contains(way)) << of_axis << " " << of_way;
            EXPECT_EQ(beam.uncut_intensity(longer), plain.uncut_intensity(way)) << of_axis << " " << of_way;
            EXPECT_NEAR(intensity(beam, longer), intensity(plain, way), 1e-15) << of_axis << " " << of_way;
          }
        const Enclosure share = beam.share(scaled(below, exactly(of_axis)), scaled(inside, exactly("1e-330")));
        EXPECT_EQ(share, plain.share(below, inside)) << of_axis;
      }
    }
}

TEST(Beam2, RightAnglesToTheAxisAreDarkWhereTheIntensityFalls) {
  for (const char* falloff : {"1/2", "1e-6", "1", "2", "1000000"})
    for (const Rational& focus : {Rational(90), Rational(180)})
      for (const Point2& axis : {Point2{1, 0}, Point2{3, 7}, scaled({3, 7}, exactly("1e-330"))}) {
        const Beam2 beam = beam_along(axis, focus, exactly(falloff));
        for (const Point2& way : {Point2{-axis.y, axis.x}, Point2{axis.y, -axis.x}}) {
          EXPECT_EQ(intensity(beam, way), 0) << falloff;
          EXPECT_EQ(beam.uncut_intensity(way), 0) << falloff;
          EXPECT_EQ(intensity(beam, scaled(way, exactly("1e400"))), 0) << falloff;
          EXPECT_TRUE(beam.contains(way));
        }
      }
  // The axis turned by 30 degrees and back by what is rational.
  const Beam2 turned = beam_along({0, 1}, 90, Rational(1, 2), 45);
  EXPECT_EQ(intensity(turned, {1, 1}), 0);
  EXPECT_EQ(intensity(turned, {-1, -1}), 0);
  EXPECT_GT(intensity(turned, {0, 1}), 0);
}

// Next to a right angle the cosine is as good as anywhere.
TEST(Beam2, NextToRightAnglesTheIntensityHasItsDigits) {
  for (const char* slope : {"1e-3", "1e-9", "1e-15", "1e-30", "1e-300"})
    for (const char* falloff : {"1/2", "1/1000", "1", "2"}) {
      const Beam2 beam = beam_along({1, 0}, 90, exactly(falloff));
      const Point2 way{exactly(slope), 1};
      const WideNumber x(slope);
      const WideNumber cosine = x / sqrt(1 + x * x);
      const Rational n = exactly(falloff);
      const WideNumber power = pow(cosine, WideNumber(n.get_num().get_str()) / WideNumber(n.get_den().get_str()));
      const double peak = intensity(beam, {1, 0});
      const double expected = peak * static_cast<double>(power);
      EXPECT_NEAR(intensity(beam, way), expected, 1e-12 * expected) << slope << " " << falloff;
      EXPECT_NEAR(beam.uncut_intensity(way), expected, 1e-12 * expected) << slope << " " << falloff;
    }
}

// The share between two angles by a rule of many points on exp(n log cos t).
double share_by_sums(double from, double to, double n) {
  constexpr int kSteps = 200'000;
  const auto sum = [n](double a, double b) {
    double total = 0;
    for (int k = 0; k < kSteps; ++k) total += std::exp(n * std::log(std::cos(a + (k + 0.5) * (b - a) / kSteps)));
    return total * (b - a) / kSteps;
  };
  const double reach = std::min(std::numbers::pi / 2, 40 / std::sqrt(n));
  return sum(std::max(from, -reach), std::min(to, reach)) / sum(-reach, reach);
}

TEST(Beam2, LargeFalloffsHaveTheirShares) {
  for (const char* falloff : {"65", "1000", "12345.5", "1000000"}) {
    const Beam2 beam = beam_along({1, 0}, 180, exactly(falloff));
    const double n = to_double(exactly(falloff)), step = 0.7 / std::sqrt(n);
    for (const double from : {-3.0, -1.0, 0.0, 0.5})
      for (const double width : {0.3, 1.0, 4.0}) {
        const double a = from * step, b = (from + width) * step;
        const Enclosure share = beam.share({1, exact_value(std::tan(a))}, {1, exact_value(std::tan(b))});
        const double expected = share_by_sums(a, b, n);
        EXPECT_NEAR(share.lower, expected, 1e-8 * expected) << falloff << " " << a << " to " << b;
        EXPECT_LE(share.width(), 0x1p-49 * share.upper);
      }
  }
}

// Far from the axis nothing is left that doubles could tell: bounds say so, and what is beyond the border gets nothing.
TEST(Beam2, WhatIsFarBelowDoublesIsBounded) {
  const Beam2 beam = beam_along({1, 0}, 180, 1'000'000);
  for (const auto& [from, to] : std::vector<std::pair<Point2, Point2>>{
           {{1, 1}, {0, 1}}, {{1, -2}, {1, -1}}, {{1, 1}, {1, -1}}, {{1, 5}, {-1, 2}}, {{20, 1}, {19, 1}}}) {
    const Enclosure share = beam.share(from, to);
    EXPECT_EQ(share.lower, 0);
    EXPECT_GT(share.upper, 0);
    EXPECT_LT(share.upper, 0x1p-960);
    EXPECT_EQ(beam.meets(from, to) == Beam2::Meets::kNothing, false);
  }
  EXPECT_EQ(beam.share({-1, 1}, {-1, -1}), (Enclosure{0, 0}));
  EXPECT_EQ(beam.share({-1, -1}, {-1, 1}).upper > 1 - 1e-15, true);
  // The parts of a turn sum to 1 all the same.
  const std::vector<Point2> around{{1, 0}, {1000, 1}, {100, 1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1000, -1}};
  double lower = 0, upper = 0;
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Enclosure share = beam.share(around[k], around[(k + 1) % around.size()]);
    lower += share.lower;
    upper += share.upper;
  }
  EXPECT_NEAR(lower, 1, 1e-15);
  EXPECT_NEAR(upper, 1, 1e-15);
}

// A needle of directions in a narrow or a wide beam.
TEST(Beam2, SharesOfNeedlesAreKnownOrBounded) {
  for (const char* falloff : {"0", "1/2", "3", "1000000"})
    for (const char* width : {"1e-200", "1e-330", "1e-4000"})
      for (const char* focus : {"180", "1", "1e-20"}) {
        const Beam2 beam = beam_along({1, 0}, exactly(focus), exactly(falloff));
        const Enclosure share = beam.share({1, 0}, {1, exactly(width)});
        EXPECT_GE(share.lower, 0);
        EXPECT_GT(share.upper, 0) << falloff << " " << width << " " << focus;
        if (std::string(width) == "1e-200") {
          EXPECT_GT(share.lower, 0) << falloff << " " << focus;
        }
      }
}

TEST(Beam2, NarrowBeamsSendAllIntoWhatHoldsThem) {
  for (const char* focus : {"1e-20", "1e-300", "1e-330", "1e-4000"})
    for (const Rational& falloff : {Rational(0), Rational(1, 2), Rational(1'000'000)}) {
      const Beam2 beam = beam_along({1, 0}, exactly(focus), falloff);
      const Enclosure all = beam.share({1, -1}, {1, 1});
      EXPECT_TRUE(all.contains(1)) << focus;
      EXPECT_LE(all.width(), 0x1p-50) << focus;
      EXPECT_EQ(beam.share({1, 1}, {1, -1}), (Enclosure{0, 0})) << focus;
      const Enclosure half = beam.share({1, 0}, {1, 1});
      EXPECT_NEAR(half.lower, 0.5, 1e-15) << focus;
      EXPECT_FALSE(beam.contains({1, exactly("1e-10")}));
      EXPECT_TRUE(beam.contains({1, 0}));
    }
}

// A million as falloff takes about what ten and a half does.
TEST(Beam2, LargeFalloffsTakeNoLongerThanSmallOnes) {
  const auto seconds = [](const char* falloff) {
    const std::clock_t begin = std::clock();  // of the processor, which others may keep busy
    const Beam2 beam = beam_along({1, 0}, 180, exactly(falloff));
    for (int k = -10; k < 10; ++k) beam.share({10, k}, {10, k + 1});
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  EXPECT_LT(seconds("1000000"), 50 * seconds("10.5") + 0.5);
}

}  // namespace
}  // namespace hottel::beam_test
