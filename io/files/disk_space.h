// Room for a file, before the work that fills it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace hottel {

// Returns the bytes that are free where a file is to be written, as those who are not root may use them; nothing where
// none need be: for a device, a pipe, "-" when standard output is no file, a folder that is not there or tells nothing.
std::optional<std::uint64_t> free_space(const std::filesystem::path& file);

// Throws RequestError "WHAT BYTES bytes; FREE are free where 'FILE' is to be" and the advice when they do not suffice.
// Passes where free_space() returns nothing.
void require_space(const std::filesystem::path& file, std::uint64_t bytes, const std::string& what,
                   const std::string& advice);

}  // namespace hottel
