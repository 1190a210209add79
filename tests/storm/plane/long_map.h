// Maps of the plane with numbers of many digits, which change nothing but the digits.
#pragma once

#include <gmpxx.h>

#include <random>

namespace hottel::storm {

// x -> a x + b y + east, y -> c x + d y + north, with a d - b c > 0.
struct LongMap {
  mpq_class a, b, c, d, east, north;

  void operator()(mpq_class& x, mpq_class& y) const {
    const mpq_class from_x = x;
    x = a * x + b * y + east;
    y = c * from_x + d * y + north;
  }
};

// Each number has 30 to 120 digits: a decimal, or a fraction with as many above as below. Lengths all change by one
// factor; with `turns` directions change too.
LongMap long_similarity(std::mt19937_64& random, bool turns);
// The same without any two numbers alike: lines stay lines, and sides sides.
LongMap long_affine_map(std::mt19937_64& random);

}  // namespace hottel::storm
