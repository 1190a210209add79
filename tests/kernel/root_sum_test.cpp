#include "kernel/root_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace hottel::root_sum_test {
namespace {

using Terms = std::vector<std::pair<Rational, Rational>>;  // coefficient, radicand

RootSum sum(const Terms& terms) {
  RootSum result;
  for (const auto& [coefficient, radicand] : terms) result.add(coefficient, radicand);
  return result;
}

Rational fraction(long p, long q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

// The value with so many bits that no sum below is mistaken for zero.
int sign_in_floating_point(const Terms& terms) {
  constexpr unsigned kBits = 4000;
  mpf_class total(0, kBits);
  for (const auto& [coefficient, radicand] : terms)
    total += mpf_class(coefficient, kBits) * sqrt(mpf_class(radicand, kBits));
  mpf_class tolerance(1, kBits);
  mpf_div_2exp(tolerance.get_mpf_t(), tolerance.get_mpf_t(), 3500);
  return abs(total) < tolerance ? 0 : sgn(total);
}

TEST(RootSum, IsCanonical) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 200; ++k) {
    RootSum s;
    for (int t = 0; t < 30; ++t)
      s.add(fraction(static_cast<long>(random() % 9) - 4, static_cast<long>(random() % 5) + 1),
            fraction(static_cast<long>(random() % 60), static_cast<long>(random() % 12) + 1));
    const auto& terms = s.terms();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      EXPECT_NE(terms[i].coefficient, 0);
      EXPECT_GT(terms[i].radicand, 0);
      for (std::size_t j = 0; j < i; ++j) {
        const Integer product = terms[i].radicand * terms[j].radicand;
        EXPECT_FALSE(mpz_perfect_square_p(product.get_mpz_t()));
      }
    }
  }
}

TEST(RootSum, IsZeroExactlyForIdentities) {
  EXPECT_TRUE(RootSum().is_zero());
  EXPECT_TRUE(sum({{0, 2}, {5, 0}}).is_zero());
  EXPECT_TRUE(sum({{1, 50}, {1, 8}, {-1, 98}}).is_zero());
  EXPECT_TRUE(sum({{3, fraction(8, 9)}, {-2, 2}}).is_zero());
  EXPECT_TRUE(sum({{1, fraction(1, 2)}, {-1, fraction(2, 4)}}).is_zero());
  EXPECT_TRUE(sum({{1, fraction(4, 9)}, {fraction(-2, 3), 1}}).is_zero());
  EXPECT_TRUE(sum({{1, 2}, {1, 3}, {1, 12}, {-3, 3}, {-1, fraction(8, 4)}}).is_zero());
  EXPECT_FALSE(sum({{1, 2}, {1, 3}, {-1, 5}}).is_zero());
  EXPECT_FALSE(sum({{1, 2}, {1, 3}, {-1, 10}}).is_zero());  // 3.1462... - 3.1622...
  // A square of a 60-digit number, which nobody factors.
  const Integer p("1000000000000000000000000000057"), q("1000000000000000000000000000099");
  EXPECT_TRUE(sum({{1, Rational(p * p * q * q * 7)}, {Rational(-p * q), 7}}).is_zero());
  EXPECT_FALSE(sum({{1, Rational(p * p * q * q * 7 + 1)}, {Rational(-p * q), 7}}).is_zero());
  EXPECT_TRUE(sum({{1, Rational(p * p * q)}, {1, Rational(9 * q)}, {-1, Rational((p + 3) * (p + 3) * q)}}).is_zero());
}

TEST(RootSum, HasTheSignOfNearlyCancellingSums) {
  // Differences of order m of the square root: about n^(1/2 - m), with terms of the size of sqrt(n).
  for (const char* start : {"10", "1000000", "1000000000000000000000000000000"})
    for (int m = 1; m <= 12; ++m) {
      Terms terms;
      Integer binomial = 1;
      for (int k = 0; k <= m; ++k) {
        terms.push_back({Rational(k % 2 == 0 ? binomial : Integer(-binomial)), Rational(Integer(start) + k)});
        binomial = binomial * (m - k) / (k + 1);
      }
      const RootSum s = sum(terms);
      EXPECT_FALSE(s.is_zero());
      EXPECT_EQ(s.sign(), sign_in_floating_point(terms));
      EXPECT_EQ(s.sign(), m % 2 == 1 ? -1 : m == 0 ? 1 : -1);
      EXPECT_EQ((s * Rational(-1)).sign(), -s.sign());
    }
  // One unit in the last of 400 digits.
  Integer n;
  mpz_ui_pow_ui(n.get_mpz_t(), 10, 400);
  EXPECT_EQ(sum({{1, Rational(n * n + 1)}, {Rational(-n), 1}}).sign(), 1);
  EXPECT_EQ(sum({{1, Rational(n * n - 1)}, {Rational(-n), 1}}).sign(), -1);
  EXPECT_EQ(sum({{1, Rational(n * n)}, {Rational(-n), 1}}).sign(), 0);
}

TEST(RootSum, HasATextThatDoesNotDependOnTheOrderOfTerms) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 100; ++k) {
    Terms terms;
    for (int t = 0; t < 12; ++t)
      terms.push_back({fraction(static_cast<long>(random() % 9) - 4, static_cast<long>(random() % 3) + 1),
                       fraction(static_cast<long>(random() % 100), static_cast<long>(random() % 10) + 1)});
    const std::string text = sum(terms).to_string();
    for (int turn = 0; turn < 5; ++turn) {
      std::shuffle(terms.begin(), terms.end(), random);
      EXPECT_EQ(sum(terms).to_string(), text);
    }
  }
}

TEST(RootSum, ReadsLikeAFormula) {
  EXPECT_EQ(RootSum().to_string(), "0");
  EXPECT_EQ(RootSum(fraction(3, 2)).to_string(), "3/2");
  EXPECT_EQ(sum({{1, 8}}).to_string(), "2*sqrt(2)");
  EXPECT_EQ(sum({{1, 10}, {-1, 8}}).to_string(), "-2*sqrt(2) + 1*sqrt(10)");
  EXPECT_EQ(sum({{1, 2}, {-1, 1}}).to_string(), "-1 + 1*sqrt(2)");
  EXPECT_EQ(sum({{1, fraction(1, 2)}, {fraction(-1, 3), 3}}).to_string(), "1/2*sqrt(2) - 1/3*sqrt(3)");
  EXPECT_EQ(sum({{1, 997 * 997 * 5}}).to_string(), "997*sqrt(5)");
}

TEST(RootSum, IsAVectorSpaceOverTheRationals) {
  std::mt19937_64 random(3);
  const auto any = [&] {
    RootSum s;
    for (int t = 0; t < 6; ++t)
      s.add(fraction(static_cast<long>(random() % 9) - 4, 3), fraction(static_cast<long>(random() % 40), 2));
    return s;
  };
  for (int k = 0; k < 100; ++k) {
    const RootSum a = any(), b = any();
    const Rational q = fraction(static_cast<long>(random() % 7) - 3, 4);
    EXPECT_TRUE((a + b - b - a).is_zero());
    EXPECT_TRUE(((a + b) * q - a * q - b * q).is_zero());
    EXPECT_TRUE((a * Rational(0)).is_zero());
    EXPECT_TRUE((a - a).is_zero());
    RootSum doubled = a;
    doubled += doubled;
    EXPECT_TRUE((doubled - a * Rational(2)).is_zero());
    RootSum nothing = a;
    const RootSum& itself = nothing;
    nothing -= itself;
    EXPECT_TRUE(nothing.is_zero());
  }
}

}  // namespace
}  // namespace hottel::root_sum_test
