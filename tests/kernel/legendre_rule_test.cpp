#include "kernel/legendre_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "kernel/wide_real.h"

namespace hottel::legendre_rule_test {
namespace {

template <class Real>
class LegendreRuleOf : public ::testing::Test {};
using Reals = ::testing::Types<double, long double, LongerReal, WideReal>;
TYPED_TEST_SUITE(LegendreRuleOf, Reals);

// The integral of x^k over [0, 1] is 1 / (k + 1).
TYPED_TEST(LegendreRuleOf, IsExactForPolynomials) {
  for (int n = 1; n <= kMaxLegendreNodes<TypeParam>; ++n) {
    const LegendreRule<TypeParam>& rule = legendre_rule<TypeParam>(n);
    ASSERT_EQ(rule.size(), n);
    for (int degree = 0; degree < 2 * n; ++degree) {
      WideReal sum = 0;
      for (std::size_t k = 0; k < rule.node.size(); ++k)
        sum += WideReal(rule.weight[k]) * pow(WideReal(rule.node[k]), degree);
      const int of_sum = std::is_same_v<TypeParam, WideReal> ? n : 0;  // it has no more digits than the rule
      const WideReal slack = (degree + 2 + of_sum) * WideReal(std::numeric_limits<TypeParam>::epsilon());
      EXPECT_NEAR(static_cast<double>((sum * (degree + 1) - 1) / slack), 0, 1) << n << " nodes, degree " << degree;
    }
  }
}

TYPED_TEST(LegendreRuleOf, IsSymmetric) {
  for (int n = 1; n <= kMaxLegendreNodes<TypeParam>; ++n) {
    const LegendreRule<TypeParam>& rule = legendre_rule<TypeParam>(n);
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const std::size_t mirrored = rule.node.size() - 1 - k;
      EXPECT_EQ(rule.weight[k], rule.weight[mirrored]);
      EXPECT_NEAR(static_cast<double>(rule.node[k] + rule.node[mirrored]), 1,
                  static_cast<double>(std::numeric_limits<TypeParam>::epsilon()));
      if (k > 0) {
        EXPECT_LT(rule.node[k - 1], rule.node[k]);
      }
    }
  }
}

// Nodes of three: 1/2 (1 -+ sqrt(3/5)), 1/2; weights 5/18, 8/18.
TYPED_TEST(LegendreRuleOf, NodesAndWeightsAreTheNearestNumbers) {
  const LegendreRule<TypeParam>& rule = legendre_rule<TypeParam>(3);
  const WideReal first = (1 - sqrt(WideReal(3) / 5)) / 2;
  if constexpr (std::is_same_v<TypeParam, WideReal>)
    EXPECT_LE(static_cast<double>(abs(rule.node[0] - first)), std::ldexp(1.0, -kWideBits));  // the root was rounded
  else
    EXPECT_EQ(rule.node[0], static_cast<TypeParam>(first));
  EXPECT_EQ(rule.node[1], TypeParam(0.5));
  EXPECT_EQ(rule.weight[0], static_cast<TypeParam>(5) / 18);
  EXPECT_EQ(rule.weight[1], static_cast<TypeParam>(8) / 18);
}

}  // namespace
}  // namespace hottel::legendre_rule_test
