// Checksums as `sha256sum` prints them.
#pragma once

#include <string>
#include <string_view>

namespace hottel {

// Returns SHA-256 of the bytes, in 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace hottel
