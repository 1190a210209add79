// A folder to write files into, that is there only if something comes into it.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "io/files/pending_removal.h"

namespace hottel {

// Makes the folder where there is none, with those that it lies in.
//
//   (1) what it made and is empty at the end is removed again: by the destructor, or when a signal ends the program
//   (2) a folder that was there before stays
class OutputFolder {
 public:
  // Throws OutputError, or std::filesystem::filesystem_error, when it cannot be made, or is a file.
  explicit OutputFolder(const std::filesystem::path& folder);
  OutputFolder(OutputFolder&&) noexcept = default;
  OutputFolder& operator=(OutputFolder&&) = delete;
  ~OutputFolder();

 private:
  std::vector<std::pair<std::filesystem::path, PendingRemoval>> made_;  // each in the one before
};

}  // namespace hottel
