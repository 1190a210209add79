// Counts in messages.
#pragma once

#include <cstdint>
#include <string>

namespace hottel {

// "1 cell", "7 cells", "0 cells".
inline std::string counted(std::uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace hottel
