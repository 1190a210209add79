// Orders of convergence between divisions: of values whose error is known.
#include "solver/compare/division_orders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hottel::division_orders_test {
namespace {

std::vector<double> values_with_error(const std::vector<std::uint32_t>& divisions, double limit, double c, double p) {
  std::vector<double> values;
  for (const std::uint32_t n : divisions) values.push_back(limit + c * std::pow(n, -p));
  return values;
}

TEST(DivisionOrders, AreThoseOfTheErrorWhateverTheDivisions) {
  for (const std::vector<std::uint32_t>& divisions :
       {std::vector<std::uint32_t>{1, 2, 4, 8}, {1, 2, 3, 5, 12}, {2, 3, 4}, {1, 10, 1000}})
    for (const double p : {0.4, 1.0, 1.7, 2.0, 4.0})
      for (const double c : {0.3, -2.0}) {
        const auto told = division_orders(divisions, values_with_error(divisions, 5, c, p), 0);
        EXPECT_FALSE(told.orders[0] || told.orders[1]);
        for (std::size_t k = 2; k < divisions.size(); ++k) EXPECT_NEAR(told.orders[k].value(), p, 1e-7) << k;
        EXPECT_NEAR(told.extrapolated.value(), 5, 1e-8);
        EXPECT_EQ(told.convergence, divisions.size() > 3 ? Convergence::kRegular : Convergence::kUnknown);
      }
}

TEST(DivisionOrders, OfAnErrorThatGrowsAreBelowZeroAndExtrapolateNothing) {
  const std::vector<std::uint32_t> divisions{1, 2, 4, 8};
  const auto told = division_orders(divisions, values_with_error(divisions, 5, 0.1, -1), 0);
  EXPECT_NEAR(told.orders[3].value(), -1, 1e-9);
  EXPECT_FALSE(told.extrapolated);
  EXPECT_EQ(told.convergence, Convergence::kGrowing);
  EXPECT_EQ(convergence_text(told), "irregular: changes grow");
  EXPECT_TRUE(is_irregular(told.convergence));
}

TEST(DivisionOrders, OfChangesOfBothSignsAreNone) {
  const std::vector<std::uint32_t> divisions{1, 2, 4};
  const auto told = division_orders(divisions, std::vector<double>{1, 2, 1.5}, 0);
  EXPECT_FALSE(told.orders[2]);
  EXPECT_FALSE(told.extrapolated);
  EXPECT_EQ(convergence_text(told), "irregular: changes of both signs");
}

TEST(DivisionOrders, ThatDifferByMoreThanAHalfAreIrregular) {
  const std::vector<std::uint32_t> divisions{1, 2, 4, 8};
  // Changes 1, 1/2, 1/16: orders 1 and 3.
  const auto told = division_orders(divisions, std::vector<double>{0, 1, 1.5, 1.5625}, 0);
  EXPECT_EQ(convergence_text(told), "irregular: orders from 1.0 to 3.0");
  EXPECT_NEAR(told.extrapolated.value(), 1.5625 + 0.0625 / 7, 1e-12) << "by the last order, and said to be irregular";
}

TEST(DivisionOrders, OfWhatNoLongerChangesAreSettled) {
  const std::vector<std::uint32_t> divisions{1, 2, 4};
  const auto told = division_orders(divisions, std::vector<double>{3, 3 + 1e-15, 3 - 1e-15}, 1e-14);
  EXPECT_EQ(told.convergence, Convergence::kSettled);
  EXPECT_EQ(told.extrapolated, 3 - 1e-15);
  EXPECT_EQ(convergence_text(told), "settled");
  // One change of nothing is chance: walls of a square by 1 and by 2.
  const auto once = division_orders(divisions, std::vector<double>{0.26975, 0.26975, 0.26963}, 1e-14);
  EXPECT_EQ(once.convergence, Convergence::kUnknown);
  EXPECT_FALSE(once.extrapolated);
  EXPECT_EQ(convergence_text(division_orders(std::span(divisions).first(2), std::vector<double>{3, 3}, 1e-14)), "");
}

TEST(DivisionOrders, OfOneOrTwoDivisionsAreUnknown) {
  EXPECT_EQ(convergence_text(division_orders({}, {}, 0)), "");
  const std::vector<std::uint32_t> divisions{3, 4};
  const auto told = division_orders(divisions, std::vector<double>{1, 2}, 0);
  EXPECT_EQ(told.convergence, Convergence::kUnknown);
  EXPECT_FALSE(told.extrapolated);
}

TEST(DivisionOrders, NeedNumbers) {
  EXPECT_FALSE(order_of_changes(1, 0, 1, 2, 4));
  EXPECT_FALSE(order_of_changes(0, 0, 1, 2, 4));
  EXPECT_FALSE(order_of_changes(std::nan(""), 1, 1, 2, 4));
  EXPECT_FALSE(order_of_changes(1e300, 1e-300, 1, 2, 4)) << "beyond any order";
}

}  // namespace
}  // namespace hottel::division_orders_test
