// A record of a store as bytes, and its checksum.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/store.h"

namespace hottel {

// Returns the ranges, columns and numbers of a row, whole numbers by 7 bits a byte, and reads them again; nothing for
// bytes that are no row of so many elements.
std::string record_of(const CachedRow& row);
std::optional<CachedRow> row_of(std::uint32_t row, std::string_view record, std::uint32_t elements);

// Texts with their lengths, one after the other, and again; nothing for bytes that are none.
std::string joined(std::span<const std::string> texts);
std::optional<std::vector<std::string>> separated(std::string_view bytes);

// SHA-256 of the parts and their lengths, in 32 bytes.
std::string digest_of(std::span<const std::string_view> parts);

}  // namespace hottel
