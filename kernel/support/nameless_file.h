// Files that nothing is left of, whatever ends the process.
#pragma once

#include <filesystem>

namespace hottel {

// Opens a new file in a folder, to read and write, that has no name; where the file system has no such files, one whose
// name is gone at once. Returns its descriptor, which children do not get; -1, and errno, where there can be none.
int open_nameless(const std::filesystem::path& folder);

}  // namespace hottel
