#include "solver/methods/ray_samples.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::uint32_t reversed(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

// Flips each binary digit by a hash of the digits before it: a scrambling that keeps dyadic intervals dyadic.
// SEE: B. Burley, Practical hash-based Owen scrambling, 2020, listing 1 (constants of S. Laine and T. Karras, 2011).
std::uint32_t owen_scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed(x);
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reversed(x);
}

std::uint64_t column_count(std::uint64_t n) { return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n))); }

}  // namespace

RaySamples::RaySamples(Sampling sampling, std::uint64_t n, std::uint64_t seed, std::uint32_t first_axis)
    : sampling_(sampling), n_(n), seed_(seed) {
  HOTTEL_REQUIRE(n >= 1 && n <= kMostRays && (first_axis == 0 || first_axis == 2));
  if (sampling == Sampling::kStratified) columns_ = column_count(n);
  if (sampling == Sampling::kSobol) {
    boost::random::sobol_engine<std::uint32_t, 32> engine(first_axis + 2);  // it leaves out the first point, 0
    sobol_.assign(2 * n, 0);
    for (std::size_t k = 2; k < sobol_.size(); k += 2) {
      for (std::uint32_t axis = 0; axis < first_axis; ++axis) engine();
      sobol_[k] = engine();
      sobol_[k + 1] = engine();
    }
  }
}

RaySamples::Point RaySamples::scrambled(std::uint64_t k, const RandomStream& random, const Point& jitter) const {
  const auto digits = [&](std::uint64_t axis, double below) {
    const std::uint32_t x = owen_scrambled(sobol_[2 * k + axis], static_cast<std::uint32_t>(random.bits(axis) >> 32));
    return below_one((x + below) * 0x1p-32);
  };
  return {digits(0, jitter.position), digits(1, jitter.turn)};
}

double parts_met_by_a_curve(Sampling sampling, std::uint64_t n) {
  const auto all = static_cast<double>(n);
  if (sampling == Sampling::kIndependent) return all;
  if (sampling == Sampling::kStratified) {
    // Each column once, and once more for each line between parts that is crossed; no column has more parts than this.
    const auto columns = static_cast<double>(column_count(n));
    return std::min(all, 2 * columns + std::ceil(all / columns));
  }
  double met = 0;  // of a grid of 2^floor(m/2) by 2^ceil(m/2) rectangles, for each power of two 2^m in n
  for (int m = 0; m < 32; ++m)
    if (n >> m & 1) met += std::ldexp(1.0, m / 2) + std::ldexp(1.0, (m + 1) / 2) - 1;
  return met;
}

}  // namespace hottel
