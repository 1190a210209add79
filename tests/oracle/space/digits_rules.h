// Integrals of functions that are analytic inside an interval, to some thirty-five digits.
#pragma once

#include <cmath>
#include <vector>

#include "tests/oracle/space/real_of_digits.h"

namespace hottel::oracle {

// Nodes of [0, 1] with weights. Those near 1 are told by their distance from it.
template <class Real>
struct DigitsRule {
  struct Node {
    Real from_end, weight;
    bool is_near_1;
  };
  std::vector<Node> nodes;

  template <class F>
  Real sum(const F& f, const Real& low, const Real& high) const {
    const Real width = high - low;
    Real result = 0;
    for (const Node& node : nodes)
      result +=
          node.weight * f(node.is_near_1 ? Real(high - width * node.from_end) : Real(low + width * node.from_end));
    return result * width;
  }
};

// The rule of Gauss and Legendre.
template <class Real>
DigitsRule<Real> gauss_digits(int n) {
  const Real pi = acos(Real(-1));
  DigitsRule<Real> rule;
  for (int k = 0; k < n; ++k) {
    Real x = cos(pi * (k + Real(3) / 4) / (n + Real(1) / 2)), slope = 1;
    for (int step = 0; step < 12; ++step) {
      Real p = 1, before = 0;
      for (int m = 0; m < n; ++m) {
        const Real next = ((2 * m + 1) * x * p - m * before) / (m + 1);
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.nodes.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope), false});
  }
  return rule;
}

// The rule of Takahasi and Mori with steps of 1 / n, for functions that are singular at ends: where they meet the ends
// weights are below 10^-40.
template <class Real>
DigitsRule<Real> tanh_sinh_digits(int n) {
  const Real half_pi = acos(Real(-1)) / 2;
  DigitsRule<Real> rule;
  for (int k = -5 * n; k <= 5 * n; ++k) {
    const Real u = Real(k) / n, e = exp(u), sinh = (e - 1 / e) / 2, cosh = (e + 1 / e) / 2;
    const Real far = exp(2 * half_pi * (sinh < 0 ? Real(-sinh) : sinh)), from_end = 1 / (1 + far);
    const Real weight = 2 * half_pi * cosh * from_end * (1 - from_end) / n;
    if (weight > Real(1e-44)) rule.nodes.push_back({from_end, weight, k > 0});
  }
  return rule;
}

// Halves until two rules agree within the tolerance; next to ends rules for singular ends are taken. Adds up what they
// differ by: the larger one, whose sum is taken, is off by far less.
template <class Real>
class DigitsIntegral {
 public:
  explicit DigitsIntegral(const Real& tolerance) : tolerance_(tolerance) {}

  template <class F>
  Real of(const F& f, const Real& low, const Real& high) {
    return part(f, low, high, 0, true, true);
  }
  double error() const { return error_; }

 private:
  static constexpr int kGaussDepth = 5, kMaxDepth = 80;

  template <class F>
  Real part(const F& f, const Real& low, const Real& high, int depth, bool is_first, bool is_last) {
    static const DigitsRule<Real> small = gauss_digits<Real>(24), large = gauss_digits<Real>(36);
    static const DigitsRule<Real> coarse = tanh_sinh_digits<Real>(16), fine = tanh_sinh_digits<Real>(32);
    const bool is_at_end = depth >= kGaussDepth && (is_first || is_last);
    const Real a = (is_at_end ? coarse : small).sum(f, low, high), b = (is_at_end ? fine : large).sum(f, low, high);
    const Real apart = a < b ? Real(b - a) : Real(a - b);
    if (apart <= tolerance_ || depth == kMaxDepth) {
      error_ += static_cast<double>(apart);
      return b;
    }
    const Real middle = (low + high) / 2;
    return part(f, low, middle, depth + 1, is_first, false) + part(f, middle, high, depth + 1, false, is_last);
  }

  Real tolerance_;
  double error_ = 0;
};

}  // namespace hottel::oracle
