// CRC-32 of bytes, as zip and gzip have it.
#pragma once

#include <cstdint>
#include <string_view>

namespace hottel {

// before: the sum of what stands before these bytes; 0 where nothing does.
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace hottel
