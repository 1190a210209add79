// The steps by which numbers are rounded (rounding.h) and signs are decided (determinant.h), and how often each was the
// last.
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

// Which step settled a sign.
//   kFilter:        doubles with their error bound
//   kCombinatorial: zero by identity: a corner lies on the planes that it is made of
//   kExact:         integers
enum class SignTier : unsigned char { kFilter, kCombinatorial, kExact };

// How many signs each tier settled, for reports and for tests that ask which one decided.
struct SignCounts {
  std::uint64_t by_tier[3] = {0, 0, 0};
  void count(SignTier tier) { ++by_tier[static_cast<int>(tier)]; }
  SignCounts& operator+=(const SignCounts& other) {
    for (int k = 0; k < 3; ++k) by_tier[k] += other.by_tier[k];
    return *this;
  }
  friend bool operator==(const SignCounts&, const SignCounts&) = default;
};

}  // namespace hottel
