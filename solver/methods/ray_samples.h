// Points of the unit square: where a ray starts on its element, and the sine of its angle.
#pragma once

#include <cstdint>
#include <vector>

namespace hottel {

// What may have been rounded to 1, and is less.
inline double below_one(double value) { return value < 1 ? value : 1 - 0x1p-53; }

// A stream of random numbers that are addressed, not drawn: the k-th one is a hash of the stream and of k. So what is
// computed from them depends neither on threads nor on order. Made for sampling, not for secrets.
// SEE: SplitMix64 (G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number generators, 2014).
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream) : start_(mix(mix(seed) + stream)) {}

  std::uint64_t bits(std::uint64_t k) const { return mix(start_ + (k + 1) * 0x9e3779b97f4a7c15ull); }
  // Uniform in (0, 1): a multiple of 2^-54, or the double nearest to one.
  double uniform(std::uint64_t k) const { return below_one((static_cast<double>(bits(k) >> 11) + 0.5) * 0x1p-53); }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  std::uint64_t start_;
};

// How the points of an element are spread over the square: see RaySamples.
enum class Sampling : unsigned char { kIndependent, kStratified, kSobol };

// n points for each element, uniform in the open unit square. Points of different elements are independent.
//
//   kIndependent  each point by itself
//   kStratified   one point in each of n rectangles of area 1/n: about sqrt(n) columns, each divided evenly, as wide as
//                 it has points
//   kSobol        the first n points of Sobol's sequence, scrambled (Owen): of the first 2^m points every dyadic
//                 rectangle of area 2^-m holds exactly one
// REQUIRES 1 <= n <= kMostRays.
inline constexpr std::uint64_t kMostRays = std::uint64_t{1} << 24;
class RaySamples {
 public:
  // COST: nothing to speak of but for kSobol: 8 bytes a point, shared by all elements. Throws
  // ContractViolation for another n.
  // first_axis: 0, or 2 for points that go with those of 0 as one point in four dimensions: Sobol's sequence then has
  // other axes. REQUIRES 0 or 2.
  RaySamples(Sampling sampling, std::uint64_t n, std::uint64_t seed, std::uint32_t first_axis = 0);

  struct Point {
    double position, turn;  // both in (0, 1)
  };
  // Calls visit(Point) for the n points of an element; always the same ones, in the same order.
  // Callable from many threads.
  template <class Visit>
  void for_each(std::uint32_t element, const Visit& visit) const {
    const RandomStream random(seed_, element);
    if (sampling_ == Sampling::kStratified) return for_each_stratum(random, visit);
    for (std::uint64_t k = 0; k < n_; ++k) {
      const Point jitter{random.uniform(2 * k + 2), random.uniform(2 * k + 3)};
      visit(sampling_ == Sampling::kIndependent ? jitter : scrambled(k, random, jitter));
    }
  }

 private:
  template <class Visit>
  void for_each_stratum(const RandomStream& random, const Visit& visit) const {
    const auto n = static_cast<double>(n_);
    for (std::uint64_t column = 0, k = 0; column < columns_; ++column) {
      const std::uint64_t first = column * n_ / columns_, last = (column + 1) * n_ / columns_;
      const auto left = static_cast<double>(first), rows = static_cast<double>(last - first);
      for (; k < last; ++k)
        visit(Point{below_one((left + rows * random.uniform(2 * k + 2)) / n),
                    below_one((static_cast<double>(k - first) + random.uniform(2 * k + 3)) / rows)});
    }
  }
  Point scrambled(std::uint64_t k, const RandomStream& random, const Point& jitter) const;

  Sampling sampling_;
  std::uint64_t n_, seed_;
  std::uint64_t columns_ = 1;
  std::vector<std::uint32_t> sobol_;  // both coordinates of one point after the other, in units of 2^-32
};

// Returns how many of n parts of area 1/n, each of which holds one point, a monotone curve through the square meets at
// the most; n when points do not lie one by one.
double parts_met_by_a_curve(Sampling sampling, std::uint64_t n);

}  // namespace hottel
