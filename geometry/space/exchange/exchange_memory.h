// What view factors in space take of memory.
#pragma once

#include <cstdint>

namespace hottel {

// At the most: an element with its patches and its row; a visible pair, from its measure to the matrix with bounds.
inline constexpr std::uint64_t kBytesPerElement3 = 1000, kBytesPerPair3 = 300;

// A thread while it measures pairs, at the most: of polygons that pierce each other (edge_integral.h).
inline constexpr std::uint64_t kBytesPerThread3 = 20'000'000;

}  // namespace hottel
