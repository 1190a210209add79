// Discs and balls, and the bound of a rule.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <utility>

#include "geometry/space/proven/ball.h"
#include "geometry/space/proven/piece_enclosure.h"
#include "geometry/space/proven/proven_polynomial.h"
#include "kernel/legendre_rule.h"

namespace hottel::discs_test {
namespace {

using Complex = std::complex<long double>;

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A disc about the origin's neighbourhood, and a point in it, often on its border.
Disc3 some_disc(std::mt19937_64& random) {
  return {between(random, -2, 2), between(random, -2, 2), std::exp2(between(random, -30, 0.5))};
}
Complex some_point(const Disc3& disc, std::mt19937_64& random) {
  const long double r = disc.rad * std::min(1.0, between(random, 0, 1.5)), a = between(random, 0, 7);
  return Complex(disc.re, disc.im) + std::polar(r, a);
}
bool holds(const Disc3& disc, const Complex& point) {
  return std::abs(point - Complex(disc.re, disc.im)) <= disc.rad * (1 + 1e-15L) || !std::isfinite(disc.rad);
}

TEST(Discs, HoldWhatComesOfTheirPoints) {
  std::mt19937_64 random(1);
  int known = 0;
  for (int k = 0; k < 20000; ++k) {
    const Disc3 a = some_disc(random), b = some_disc(random);
    const Complex p = some_point(a, random), q = some_point(b, random);
    EXPECT_TRUE(holds(a + b, p + q));
    EXPECT_TRUE(holds(a - b, p - q));
    EXPECT_TRUE(holds(a * b, p * q));
    EXPECT_TRUE(holds(inverse(a), Complex(1) / p));
    EXPECT_TRUE(holds(root(a), std::sqrt(p)));
    EXPECT_TRUE(holds(arc_tangent(a), std::atan(p)));
    known += std::isfinite(root(a).rad) && std::isfinite(arc_tangent(a).rad) ? 1 : 0;
  }
  EXPECT_GT(known, 10000);
}

// What rounding alone leaves: discs of numbers that doubles are.
TEST(Discs, OfPointsHoldWhatDoublesRoundAway) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 20000; ++k) {
    const Disc3 a{between(random, -2, 2), k % 4 == 0 ? 0 : between(random, -2, 2), 0}, b = some_disc(random);
    const Complex p(a.re, a.im), q(b.re, b.im);
    const Disc3 point{b.re, b.im, 0};
    for (const auto& [disc, value] : {std::pair(a * point, p * q),
                                      {inverse(a), Complex(1) / p},
                                      {root(a), std::sqrt(p)},
                                      {arc_tangent(a), std::atan(p)}}) {
      if (!std::isfinite(disc.rad)) continue;
      EXPECT_TRUE(holds(disc, value));
      EXPECT_LE(disc.rad, 1e-9);  // near the ends of cuts
    }
  }
}

// Coefficients anywhere in their balls, at points of the disc; and what a polynomial spans is told closely.
TEST(ProvenPolynomials, HoldTheirValuesOverDiscs) {
  std::mt19937_64 random(6);
  for (int n = 0; n < 4000; ++n) {
    ProvenPolynomial3 polynomial;
    polynomial.count = 1 + random() % ProvenPolynomial3::kMost;
    const double off = n % 2 == 0 ? 0 : 1e-3;
    for (std::size_t k = 0; k < polynomial.count; ++k) polynomial.coefficient[k] = {between(random, -2, 2), off};
    const Disc3 disc = some_disc(random), values = over(polynomial, disc);
    for (int m = 0; m < 8; ++m) {
      const Complex point = some_point(disc, random);
      Complex value = 0;
      for (std::size_t k = polynomial.count; k-- > 0;)
        value = value * point + static_cast<long double>(polynomial.coefficient[k].mid + between(random, -off, off));
      EXPECT_TRUE(holds(values, value));
    }
  }
  // A line spans a disc; a square about its own root as well.
  const ProvenPolynomial3 line{{{{1, 0}, {2, 0}}}, 2}, square{{{{0, 0}, {0, 0}, {1, 0}}}, 3};
  EXPECT_NEAR(over(line, {3, 4, 0.5}).rad, 1, 1e-12);
  EXPECT_NEAR(over(square, {0, 0, 0.5}).rad, 0.25, 1e-12);
}

// Sums and products of vectors are those of their values.
TEST(ProvenPolynomials, AreThoseOfVectors) {
  std::mt19937_64 random(7);
  const auto some_vector = [&](bool is_linear) {
    ProvenVector3<double> v;
    for (auto& power : v.power) power = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    if (is_linear) v.power[2] = {};
    v.is_linear = is_linear;
    v.base = between(random, 0, 1);
    return v;
  };
  for (int n = 0; n < 2000; ++n) {
    const auto a = some_vector(n % 2 == 0), b = some_vector(n % 3 == 0), c = some_vector(n % 5 == 0);
    const double from = between(random, 0, 1), t = between(random, 0, 1);
    const auto at_t = [&](const ProvenVector3<double>& v) { return at(v, Ball3<double>{t - v.base, 1e-16}); };
    const Disc3 u{t - from, 0, 1e-16};
    const Disc3 found = over(dot(about(a, from), cross(about(b, from), about(c, from))), u),
                product = over(dot(about(a, from), about(b, from)), u);
    EXPECT_NEAR(found.re, dot(at_t(a), cross(at_t(b), at_t(c))).mid, 1e-13);
    EXPECT_NEAR(product.re, dot(at_t(a), at_t(b)).mid, 1e-13);
    EXPECT_LE(std::max(found.rad, product.rad), 1e-12);
  }
}

TEST(Discs, AtCutsKnowNothing) {
  EXPECT_FALSE(std::isfinite(root({-1, 0.1, 0.2}).rad));
  EXPECT_FALSE(std::isfinite(root({0.1, 0, 0.2}).rad));
  EXPECT_TRUE(std::isfinite(root({-1, 0.3, 0.2}).rad));
  EXPECT_TRUE(std::isfinite(root({0.3, 0, 0.2}).rad));
  EXPECT_FALSE(std::isfinite(arc_tangent({0.1, 1.5, 0.2}).rad));
  EXPECT_FALSE(std::isfinite(arc_tangent({0, -0.9, 0.2}).rad));
  EXPECT_TRUE(std::isfinite(arc_tangent({0.3, 1.5, 0.2}).rad));
  EXPECT_TRUE(std::isfinite(arc_tangent({0, 0.7, 0.2}).rad));
  EXPECT_FALSE(std::isfinite(inverse(Disc3{0.1, 0.1, 0.2}).rad));
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
}  // namespace hottel::discs_test
