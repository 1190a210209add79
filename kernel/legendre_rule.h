// The rules of Gauss-Legendre for integrals over [0, 1].
#pragma once

#include <limits>
#include <vector>

namespace hottel {

// Nodes in [0, 1], ascending, and weights that sum up to 1. A rule of n nodes is exact for polynomials of degree 2n
// - 1.
//
//   (1) every node and every weight is the number nearest to the true one, or its neighbour
//   (2) the true nodes k and n - 1 - k sum up to 1, and have the same weight
template <class Real>
struct LegendreRule {
  std::vector<Real> node, weight;

  int size() const { return static_cast<int>(node.size()); }
};

// How many nodes a rule has at most.
template <class Real>
inline constexpr int kMaxLegendreNodes = std::numeric_limits<Real>::digits > 200 ? 48 : 20;

// Returns the rule of n nodes. REQUIRES: 1 <= n <= kMaxLegendreNodes<Real>; Real is double, long double, LongerReal or
// WideReal.
// COST: nothing; the first call makes all rules of a Real, in some milliseconds.
template <class Real>
const LegendreRule<Real>& legendre_rule(int n);

}  // namespace hottel
