// Arithmetic of sums of two doubles that the compiler can do: some 100 bits. Internal to kernel.
#pragma once

#include <bit>
#include <cstdint>

#include "kernel/int128.h"

namespace hottel::same_bits {

// The sum, exactly. REQUIRES: a is 0 or its exponent is not less than that of b.
constexpr DoubleDouble ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, (a - sum) + b};
}

// The sum, exactly.
constexpr DoubleDouble exact_sum(double a, double b) {
  DoubleDouble sum;
  two_sum(a, b, sum.hi, sum.lo);
  return sum;
}

// The upper half of the bits: products of two of them are exact.
constexpr double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000);
}

// The product, exactly. REQUIRES: it is neither very large nor nearly subnormal.
constexpr DoubleDouble exact_product(double a, double b) {
  DoubleDouble product;
  two_product(a, b, product.hi, product.lo);
  return product;
}

constexpr DoubleDouble plus(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = exact_sum(a.hi, b.hi);
  return ordered_sum(sum.hi, sum.lo + (a.lo + b.lo));
}
constexpr DoubleDouble times(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.hi, b.hi);
  return ordered_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}
constexpr DoubleDouble over(const DoubleDouble& a, double b) {
  const double first = a.hi / b;
  const DoubleDouble product = exact_product(first, b);
  return ordered_sum(first, (((a.hi - product.hi) - product.lo) + a.lo) / b);
}

// z + z^3/3 + z^5/5 + ..., or with alternating signs. REQUIRES: z < 1/50, so that nothing is left of 2^-105.
constexpr DoubleDouble odd_series(const DoubleDouble& z, int sign) {
  const DoubleDouble square = times(z, z);
  DoubleDouble power = z, sum = z;
  for (int n = 3; n <= 19; n += 2) {
    power = times(power, {square.hi * sign, square.lo * sign});
    sum = plus(sum, over(power, n));
  }
  return sum;
}

}  // namespace hottel::same_bits
