// Numbers as PNG files have them.
#pragma once

#include <cstdint>
#include <string>

namespace hottel {

// Four bytes, the highest first.
inline std::string big_endian(std::uint32_t number) {
  return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
          static_cast<char>(number)};
}

}  // namespace hottel
