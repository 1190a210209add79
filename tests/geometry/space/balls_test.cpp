// Balls, and the bound of a rule.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/space/proven/ball.h"
#include "geometry/space/proven/piece_enclosure.h"
#include "kernel/legendre_rule.h"

namespace hottel::balls_test {
namespace {

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

TEST(Balls, HoldWhatComesOfTheirNumbers) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 20000; ++k) {
    const auto some_ball = [&] { return Ball3<double>{between(random, 0.1, 2), std::exp2(between(random, -60, -4))}; };
    const auto some_number = [&](const Ball3<double>& ball) {
      return static_cast<long double>(ball.mid) + ball.rad * std::clamp(between(random, -2, 2), -1.0, 1.0);
    };
    const auto expect = [](const Ball3<double>& ball, long double value) {
      EXPECT_LE(std::fabs(value - ball.mid), ball.rad);
    };
    const Ball3<double> a = some_ball(), b = some_ball();
    const long double p = some_number(a), q = some_number(b);
    expect(a + b, p + q);
    expect(a - b, p - q);
    expect(a * b, p * q);
    expect(inverse(a), 1 / p);
    expect(root(a), std::sqrt(p));
    expect(arc_tangent(a), std::atan(p));
  }
}

// Chebyshev polynomials are as large on the ellipse as their degree lets them, and the first that a rule does not have
// is all but lost: the bound is of the size of what it bounds.
TEST(ErrorOfRule, IsNoLessThanWhatARuleIsOff) {
  for (int n = 2; n <= 20; ++n)
    for (const double rho : {1.3, 2.0, 5.0}) {
      const LegendreRule<double>& rule = legendre_rule<double>(n);
      double sum = 0;
      for (int k = 0; k < n; ++k) sum += 2 * rule.weight[k] * std::cos(2 * n * std::acos(2 * rule.node[k] - 1));
      const double integral = -2.0 / (4 * n * n - 1), largest = (std::pow(rho, 2 * n) + std::pow(rho, -2 * n)) / 2;
      const double off = std::fabs(sum - integral), bound = error_of_rule_3(largest, rho, n);
      EXPECT_LE(off, bound);
      EXPECT_GE(off, (rho > 2 ? 0.5 : 0.1) * bound);
    }
  // All its terms, whatever is off: the geometric series counts where the ellipse is narrow.
  EXPECT_GE(error_of_rule_3(1, 1.1, 2), 32.0 / 15 * 2 * std::pow(1.1, -4) / (1 - std::pow(1.1, -2)));
}

}  // namespace
}  // namespace hottel::balls_test
