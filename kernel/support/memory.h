// How much memory work may take.
#pragma once

#include <cstdint>

namespace hottel {

// Returns `asked` bytes, or where none are asked for (0) 80 % of the memory that is free.
std::uint64_t memory_allowed(std::uint64_t asked = 0);

}  // namespace hottel
