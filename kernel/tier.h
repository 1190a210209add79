// The steps of the rounding ladder (rounding.h), and how often each was the last.
#pragma once

#include <cstdint>

namespace hottel {

// Which step of the ladder settled a number.
//   kDouble:       nothing was rounded on the way (zero, or every length an integer)
//   kDoubleDouble: 128-bit fixed-point sums (106 bits and more) with their error bound
//   kBall:         ball arithmetic of sufficient precision on the exact sums
//   kRootSum:      the canonical sum of square roots: ties, numbers that are doubles, and multiples of one root
enum class Tier : unsigned char { kDouble, kDoubleDouble, kBall, kRootSum };

// How many numbers each tier settled, for reports and for tests that ask which one decided.
struct TierCounts {
  std::uint64_t by_tier[4] = {0, 0, 0, 0};
  void count(Tier tier) { ++by_tier[static_cast<int>(tier)]; }
  TierCounts& operator+=(const TierCounts& other) {
    for (int k = 0; k < 4; ++k) by_tier[k] += other.by_tier[k];
    return *this;
  }
  friend bool operator==(const TierCounts&, const TierCounts&) = default;
};

}  // namespace hottel
