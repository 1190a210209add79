// Gauss-Legendre quadrature of [0, 1].
#pragma once

#include <string_view>
#include <vector>

namespace hottel {

// Places in (0, 1) and weights that sum to 1: exact for polynomials of degree 2 n - 1.
struct GaussRule {
  std::vector<double> place, weight;
};
// REQUIRES n >= 1. COST: some microseconds a point.
GaussRule gauss_rule(int n);

// The whole number of a variant ":n". Throws UsageError, telling the family and the range, for what is none or is out
// of it.
int count_of_variant(std::string_view family, std::string_view variant, int most);

}  // namespace hottel
