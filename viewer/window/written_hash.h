// Checksums of what would be written.
#pragma once

#include <string>
#include <string_view>

#include "io/files/text_file.h"

namespace hottel {

// Returns the SHA-256 of all bytes that write(sink) hands to its sink.
template <class Write>
std::string written_hash(const Write& write) {
  std::string bytes;
  write([&bytes](std::string_view more) { bytes += more; });
  return sha256(bytes);
}

}  // namespace hottel
