// What view factors in space take of memory.
#pragma once

#include <cstdint>

namespace hottel {

// At the most: an element with its patches and its row; a visible pair, from its measure to the matrix with bounds.
inline constexpr std::uint64_t kBytesPerElement3 = 1000, kBytesPerPair3 = 300;

}  // namespace hottel
