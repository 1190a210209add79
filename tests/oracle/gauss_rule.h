// Nodes and weights of Gauss and Legendre on (0, 1), by Newton's iteration on Legendre polynomials.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace hottel {

struct GaussRule {
  std::vector<long double> node, weight;

  explicit GaussRule(int n) {
    for (int k = 0; k < n; ++k) {
      long double x = std::cos(std::numbers::pi_v<long double> * (k + 0.75L) / (n + 0.5L)), slope = 1;
      for (int step = 0; step < 60; ++step) {
        long double p = 1, before = 0;
        for (int m = 0; m < n; ++m) {
          const long double next = ((2 * m + 1) * x * p - m * before) / (m + 1);
          before = p;
          p = next;
        }
        slope = n * (x * p - before) / (x * x - 1);
        x -= p / slope;
      }
      node.push_back((1 + x) / 2);
      weight.push_back(1 / ((1 - x * x) * slope * slope));
    }
  }
};

}  // namespace hottel
