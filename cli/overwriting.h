// Files that a command reads and writes.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace hottel {

// Whether both are names of one file that is there.
inline bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& two) {
  std::error_code missing;
  return std::filesystem::equivalent(one, two, missing) && !missing;
}

// What is told where a repaired scene goes where the scene was.
inline std::string overwriting_note(const std::string& file, bool is_written) {
  return file + (is_written ? " is overwritten by the repaired scene" : " is left as it is: nothing is repaired");
}

}  // namespace hottel
