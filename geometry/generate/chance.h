// Chance for scenes that are made up: the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "kernel/int128.h"

namespace hottel {

// Chance from std::mt19937_64, whose raw output the standard fixes.
//
//   (1) a seed gives the same numbers on every machine: no distribution of the library is used
//   (2) each call takes one word from the engine
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  // A number in [0, count). The bias is below count / 2^64.
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>((static_cast<UInt128>(engine_()) * count) >> 64);
  }
  // A number in [low, high]. REQUIRES: low <= high.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }

 private:
  std::mt19937_64 engine_;
};

// Returns count of the numbers below n, no two of them equal, in the order in which they were drawn.
// REQUIRES: 0 <= count <= n.
std::vector<std::int64_t> drawn(std::int64_t count, std::int64_t n, Chance& chance);

// Returns the integer part r of the square root: r^2 <= value < (r + 1)^2, for every value of the type.
std::uint64_t integer_root(std::uint64_t value);

// Returns the least r with r^2 >= value, or r^3 >= value. REQUIRES: value < 2^60.
std::int64_t side_of_square(std::uint64_t value);
std::int64_t side_of_cube(std::uint64_t value);

// Returns stem followed by the number.
template <class Number>
std::string numbered(const char* stem, Number number) {
  return std::string(stem).append(std::to_string(number));
}

}  // namespace hottel
