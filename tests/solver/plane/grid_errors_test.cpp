// Light on a grid beside the exact light: errors by cell, and how it may have been turned or scaled.
#include "solver/compare/grid_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hottel::grid_errors_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

GridValues grid_of(const std::vector<double>& values) { return {2, 3, 1, values}; }

TEST(GridErrors, AreOverCellsThatBothHaveAndSayWhere) {
  const double nan = std::nan("");
  const std::vector<double> exact = {1, 2, nan, 4, 5, 6}, found = {1, 2.5, 7, kInfinity, 5, 4};
  const GridErrors errors = grid_errors(grid_of(found), grid_of(exact), 1e-6, {}).at(0);
  EXPECT_EQ(errors.cells, 4u);
  EXPECT_EQ(errors.missing, 1u);
  EXPECT_EQ(errors.extra, 1u);
  EXPECT_EQ(errors.off, 2u);
  EXPECT_EQ(grid_errors(grid_of(found), grid_of(exact), 0.1, {}).at(0).off, 1u) << "a tenth of 6";
  EXPECT_EQ(grid_errors(grid_of(found), grid_of(exact), 0, {0, 0, 0.6}).at(0).off, 0u) << "digits of the file";
  EXPECT_EQ(errors.max, 2);
  EXPECT_DOUBLE_EQ(errors.rms, std::sqrt((0.25 + 4) / 4));
  EXPECT_EQ(errors.ix, 2u);
  EXPECT_EQ(errors.iy, 1u);
  EXPECT_EQ(errors.value, 4);
  EXPECT_EQ(errors.exact, 6);
  EXPECT_EQ(errors.largest, 6);
}

TEST(GridErrors, AreReadAsTurnedOrScaledLight) {
  const std::vector<double> exact = {1, 2, 3, 4, 5, 7};
  const auto read = [&](const std::vector<double>& found) { return grid_reading(grid_of(found), grid_of(exact)); };
  EXPECT_EQ(read(exact), "");
  EXPECT_EQ(read({1.1, 1.8, 3, 4.3, 5.2, 6.7}), "");
  EXPECT_THAT(read({4, 5, 7, 1, 2, 3}), ::testing::StartsWith("upside down"));
  EXPECT_THAT(read({3, 2, 1, 7, 5, 4}), ::testing::StartsWith("left for right"));
  std::vector<double> scaled = exact;
  for (double& value : scaled) value *= 2 * std::numbers::pi;
  EXPECT_EQ(read(scaled), "times 2 pi");
  for (double& value : scaled) value *= 2;
  EXPECT_EQ(read(scaled), "times 4 pi");
  for (double& value : scaled) value /= 2;
  std::swap_ranges(scaled.begin(), scaled.begin() + 3, scaled.begin() + 3);
  EXPECT_THAT(read(scaled),
              ::testing::AllOf(::testing::StartsWith("upside down"), ::testing::EndsWith("and times 2 pi")));
}

TEST(GridErrors, AreReadAsExchangedAxesWhereThereAreAsManyOfBoth) {
  const std::vector<double> exact = {1, 2, 4, 8, 16, 32, 64, 128, 256};
  const auto square = [](const std::vector<double>& values) { return GridValues{3, 3, 1, values}; };
  const auto read = [&](const std::vector<double>& found) { return grid_reading(square(found), square(exact)); };
  EXPECT_THAT(read({1, 8, 64, 2, 16, 128, 4, 32, 256}), ::testing::StartsWith("that of exchanged axes"));
  EXPECT_THAT(read({4, 32, 256, 2, 16, 128, 1, 8, 64}), ::testing::StartsWith("turned by a quarter"));
  EXPECT_THAT(read({2, 16, 128, 4, 32, 256, 8, 64, 512}), ::testing::EndsWith("and times 2")) << "exchanged, doubled";
}

}  // namespace
}  // namespace hottel::grid_errors_test
