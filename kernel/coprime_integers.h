// Integers in the ratio of rational numbers.
#pragma once

#include <array>
#include <cstddef>

#include "kernel/rational.h"

namespace hottel {

// Returns the coprime integers that are to each other as these numbers are, with the same signs; zeros for zeros.
//
//   (1) the same for numbers times any positive factor
template <std::size_t N>
std::array<Integer, N> coprime_integers(const std::array<Rational, N>& values) {
  Integer denominator = 1, divisor = 0;
  for (const Rational& value : values) denominator = lcm(denominator, value.get_den());
  std::array<Integer, N> integers;
  for (std::size_t k = 0; k < N; ++k) {
    integers[k] = values[k].get_num() * (denominator / values[k].get_den());
    divisor = gcd(divisor, integers[k]);
  }
  if (divisor > 1)
    for (Integer& value : integers) value /= divisor;
  return integers;
}

}  // namespace hottel
