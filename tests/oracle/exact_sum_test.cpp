#include "tests/oracle/exact_sum.h"

#include <gtest/gtest.h>

namespace hottel::oracle::exact_sum_test {
namespace {

TEST(OracleExactSum, IsWrittenWithSquareFreeRadicandsInAscendingOrder) {
  EXPECT_EQ(ExactSum({{1, 40}, {-1, 8}, {mpq_class(3, 2), 1}}).to_string(), "3/2 - 2*sqrt(2) + 2*sqrt(10)");
  EXPECT_EQ(ExactSum({{-2, 2}, {1, 10}}).to_string(), "-2*sqrt(2) + 1*sqrt(10)");
  EXPECT_EQ(ExactSum().to_string(), "0");
}

TEST(OracleExactSum, TakesRootsOfFractions) {
  EXPECT_EQ(ExactSum({{1, mpq_class(1, 2)}}).to_string(), "1/2*sqrt(2)");
  EXPECT_EQ(ExactSum({{1, mpq_class(4, 9)}}).to_string(), "2/3");
}

TEST(OracleExactSum, HasNoTermsIffItIsZero) {
  EXPECT_TRUE(ExactSum({{3, 2}, {-1, 18}}).terms().empty());
  EXPECT_TRUE(ExactSum({{1, 0}, {0, 5}}).terms().empty());
  EXPECT_EQ(ExactSum({{1, 2}, {1, 3}, {-1, 5}}).terms().size(), 3u);
}

TEST(OracleExactSum, FindsSquaresOfLargePrimes) {
  const mpz_class p = 1000003, q = 10007;
  const auto [root, rest] = take_out_squares(p * p * q * 12);
  EXPECT_EQ(root, 2 * p);
  EXPECT_EQ(rest, 3 * q);
}

TEST(OracleExactSum, GroupsRadicandsTooLongToFactor) {
  const mpz_class p("170141183460469231731687303715884105727"), q("2305843009213693951");  // Mersenne primes
  ExactSum sum({{1, p * q}, {-1, q * p * 9}});
  EXPECT_EQ(sum, ExactSum({{-2, p * q}}));
  EXPECT_TRUE(ExactSum({{1, p * p * p * q}, {-p, p * q}}).terms().empty());
}

TEST(OracleExactSum, AddsAndScales) {
  ExactSum sum({{1, 2}, {1, 3}});
  sum += ExactSum({{-1, 2}, {1, 3}});
  EXPECT_EQ(sum.to_string(), "2*sqrt(3)");
  sum += sum;
  sum *= mpq_class(1, 2);
  EXPECT_EQ(sum.to_string(), "2*sqrt(3)");
  EXPECT_NEAR(sum.to_double(), 3.4641016151377545870548926830117, 1e-15);
}

}  // namespace
}  // namespace hottel::oracle::exact_sum_test
