#include "io/files/folder_hold.h"

#include <fcntl.h>
#include <unistd.h>

#include <system_error>
#include <utility>

#include "io/files/abandoned.h"

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

}  // namespace hottel
