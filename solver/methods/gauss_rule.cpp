#include "solver/methods/gauss_rule.h"

#include <fmt/format.h>

#include <boost/math/special_functions/legendre.hpp>
#include <charconv>

#include "kernel/support/failure.h"

namespace hottel {

GaussRule gauss_rule(int n) {
  GaussRule rule;
  const auto add = [&rule](double zero, double doubled_weight) {
    rule.place.push_back((1 + zero) / 2);
    rule.weight.push_back(doubled_weight / 2);
  };
  for (const double zero : boost::math::legendre_p_zeros<double>(n)) {  // those that are not negative
    const double slope = boost::math::legendre_p_prime(n, zero);
    const double weight = 2 / ((1 - zero) * (1 + zero) * slope * slope);
    if (zero > 0) add(-zero, weight);
    add(zero, weight);
  }
  return rule;
}

int count_of_variant(std::string_view family, std::string_view variant, int most) {
  int n = 0;
  const char* const end = variant.data() + variant.size();
  if (!variant.empty())
    if (const auto read = std::from_chars(variant.data() + 1, end, n);
        read.ec == std::errc() && read.ptr == end && n >= 1 && n <= most)
      return n;
  throw UsageError(fmt::format("{0}:n wants a number of points from 1 to {1}", family, most));
}

}  // namespace hottel
