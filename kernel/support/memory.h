// How much memory work may take.
#pragma once

#include <cstdint>

namespace hottel {

// Returns how many bytes may be taken.
//
//   (1) `asked` itself where it is not 0, however much memory there is
//   (2) else 80 % of the memory that the system says is available now
//   (3) else, where it does not say so (no /proc/meminfo), 80 % of the memory that is installed
std::uint64_t memory_allowed(std::uint64_t asked = 0);

}  // namespace hottel
