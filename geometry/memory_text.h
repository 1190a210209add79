// How messages tell of memory.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/scene_table.h"

namespace hottel {

// "1.2 GB", "1 byte": decimal units, two digits.
std::string short_bytes(double bytes);
// The same, and all digits where there are more: "1.2 GB (1234567890 bytes)".
std::string limit_text(std::uint64_t bytes);

// Throws RequestError: so many of what ("visible pairs") need `each` bytes, more than the limit. To take fewer elements
// is advised where the scene is divided, --memory is named where the limit is far below what is free.
[[noreturn]] void refuse_memory(const SceneTable& scene, std::uint64_t count, const std::string& what,
                                std::uint64_t each, std::uint64_t limit);

}  // namespace hottel
