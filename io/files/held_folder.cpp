#include "io/files/held_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/files/output_file.h"

namespace hottel {

FolderHold::FolderHold(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {
  std::error_code unknown;
  is_held_ = descriptor_ < 0 ? std::filesystem::exists(folder, unknown) : hold_temporary(descriptor_, folder.string());
}

FolderHold::FolderHold(FolderHold&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), is_held_(std::exchange(other.is_held_, false)) {}

FolderHold& FolderHold::operator=(FolderHold&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(is_held_, other.is_held_);
  return *this;
}

FolderHold::~FolderHold() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

OwnFolder::OwnFolder(const std::filesystem::path& place, Abandoned kind) {
  remove_abandoned(place, kind);
  while (!hold_.is_held()) {
    std::string pattern = (place / temporary_folder_pattern(kind)).string();
    if (!::mkdtemp(pattern.data()))
      throw OutputError(place.string(), std::string("no folder can be made there: ") + std::strerror(errno));
    path_ = pattern;
    pending_ = PendingRemoval(pattern, Removal::kFolder);
    hold_ = FolderHold(path_);
  }
}

OwnFolder::~OwnFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace hottel
