// A text file as a whole, and checksums.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "kernel/support/failure.h"

namespace hottel {

// The largest text that is read: line numbers and offsets stay within 31 bits.
inline constexpr std::size_t kMaxTextFileBytes = 0x7fffffff;

// Returns the bytes of a file. Throws MissingFile when there is none, InputError naming the file when it is a
// directory, not readable, or larger than kMaxTextFileBytes.
std::string read_text_file(const std::filesystem::path& file);

// Where readers get the files that a file names: read_text_file, or texts in memory. Throws as that does.
using TextSource = std::function<std::string(const std::filesystem::path&)>;

// Returns a file that another one names. Throws InputError at the place where it is named, naming both, when `files`
// has no such file. `what` is for the message: "the MTL file".
std::string read_named_file(const TextSource& files, const std::filesystem::path& file, const FileLine& where,
                            const std::string& what);

// Returns all that is on standard input. Throws InputError naming it when it cannot be read or is larger.
std::string read_standard_input();

// Returns SHA-256 of the bytes in 64 hexadecimal digits, as `sha256sum` prints it: lower case.
std::string sha256(std::string_view bytes);

}  // namespace hottel
