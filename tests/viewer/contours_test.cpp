// Lines along which a field of pixels has one value.
#include "viewer/picture/contours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/viewer/pixel_fields.h"

namespace hottel::contours_test {
namespace {

using pixel_fields::field;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Contours2, OfACircleAreThatCircleClosed) {
  const PixelField round = field(40, 30, [](double x, double y) { return std::hypot(x - 20, y - 15); });
  const auto lines = contour_lines(round, 10);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  for (const Pixel& p : lines[0]) EXPECT_NEAR(std::hypot(p.x - 20, p.y - 15), 10, 0.02);
  EXPECT_THAT(contour_lines(round, 100), IsEmpty());
}

TEST(Contours2, HaveTheLevelWhereTheyMeetSidesOfSquares) {
  std::mt19937 random(3);
  PixelField rough = field(50, 40, [&](double, double) { return static_cast<double>(random() % 1000); });
  const float nan = std::numeric_limits<float>::quiet_NaN();
  rough.values[777] = nan;
  std::size_t points = 0, sides = 0;
  const double level = 500.5;
  for (const PixelLine& line : contour_lines(rough, level))
    for (std::size_t k = 0; k < line.size(); ++k) {
      const double x = line[k].x - 0.5, y = line[k].y - 0.5;
      ASSERT_TRUE(x == std::floor(x) || y == std::floor(y)) << "on a side";
      const auto at = [&](double i, double j) {
        return double{rough.values[static_cast<std::size_t>(j) * rough.width + static_cast<std::size_t>(i)]};
      };
      const double a = at(std::floor(x), std::floor(y)), b = at(std::ceil(x), std::ceil(y));
      const double t = x == std::floor(x) ? y - std::floor(y) : x - std::floor(x);
      EXPECT_NEAR(a + t * (b - a), level, 1e-6);
      points += k > 0 || line.front() != line.back();  // a closed line has its first point twice
    }
  // Every side with the level between its ends, both squares at it whole or one, is met once: the slow way.
  for (std::uint32_t y = 0; y < rough.height; ++y)
    for (std::uint32_t x = 0; x < rough.width; ++x) {
      const auto at = [&](std::uint32_t i, std::uint32_t j) { return rough.values[j * rough.width + i]; };
      const auto is_whole = [&](std::int64_t i, std::int64_t j) {
        if (i < 0 || j < 0 || i + 1 >= rough.width || j + 1 >= rough.height) return false;
        const auto u = static_cast<std::uint32_t>(i), v = static_cast<std::uint32_t>(j);
        return !std::isnan(at(u, v) + at(u + 1, v) + at(u, v + 1) + at(u + 1, v + 1));
      };
      if (x + 1 < rough.width && (at(x, y) >= level) != (at(x + 1, y) >= level))
        sides += is_whole(x, y) || is_whole(x, std::int64_t{y} - 1);
      if (y + 1 < rough.height && (at(x, y) >= level) != (at(x, y + 1) >= level))
        sides += is_whole(x, y) || is_whole(std::int64_t{x} - 1, y);
    }
  EXPECT_EQ(points, sides);
}

TEST(Contours2, DoNotRunThroughWallsNorWhereThereIsNoValue) {
  PixelField slope = field(9, 9, [](double x, double) { return x; });
  slope.cut.assign(64, false);
  for (std::size_t x = 0; x < 8; ++x) slope.cut[4 * 8 + x] = true;  // a wall across, between the rows 4 and 5
  const auto lines = contour_lines(slope, 3);
  ASSERT_EQ(lines.size(), 2u);
  for (const PixelLine& line : lines)
    for (const Pixel& p : line) EXPECT_TRUE(p.x == 3 && (p.y <= 4.5 || p.y >= 5.5));
}

TEST(Contours2, SimplifiedStayWithinTheTolerance) {
  PixelLine wave;
  for (int k = 0; k <= 400; ++k) wave.push_back({k * 0.5, 20 * std::sin(k * 0.05)});
  const PixelLine few = simplified_line(wave, 0.25);
  EXPECT_LT(few.size(), 60u);
  EXPECT_EQ(few.front(), wave.front());
  EXPECT_EQ(few.back(), wave.back());
  for (const Pixel& p : wave) {
    double nearest = 1e9;
    for (std::size_t k = 0; k + 1 < few.size(); ++k)
      for (double t = 0; t <= 1; t += 1.0 / 512)
        nearest = std::min(nearest, std::hypot(std::lerp(few[k].x, few[k + 1].x, t) - p.x,
                                               std::lerp(few[k].y, few[k + 1].y, t) - p.y));
    EXPECT_LT(nearest, 0.26);
  }
}

TEST(Contours2, LevelsAreRoundAndInside) {
  EXPECT_THAT(contour_levels(0.3, 12, 10), ElementsAre(0.5, 1, 2, 5, 10));
  EXPECT_THAT(contour_levels(0.3, 12, 3), ElementsAre(1, 3, 10));
  EXPECT_THAT(contour_levels(0.3, 12, 2), ElementsAre(1, 10));
  EXPECT_THAT(contour_levels(2, 4.5, 5), ElementsAre(3, 4));
  EXPECT_THAT(contour_levels(2, 4.5, 6), ElementsAre(2.5, 3, 3.5, 4));
  EXPECT_THAT(contour_levels(1.1, 1.5, 6), ElementsAre(1.2, 1.3, 1.4));
  EXPECT_THAT(contour_levels(1e-9, 1e3, 5), ElementsAre(1e-6, 1e-3, 1));
  EXPECT_THAT(contour_levels(0, 4.5, 5), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(contour_levels(0, 0, 5), IsEmpty());
  EXPECT_THAT(contour_levels(3, 3, 5), IsEmpty());
}

}  // namespace
}  // namespace hottel::contours_test
