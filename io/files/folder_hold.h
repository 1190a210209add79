// Folders that one run at a time has.
#pragma once

#include <filesystem>

namespace hottel {

// Says to all processes that a folder is in use, for as long as this lives, and as commands run that this process
// started meanwhile: they inherit it, and may write there.
//
//   (1) a folder that somebody holds is not held by anybody else, in this process either
//   (2) where a file system has no locks, or the folder cannot be read, nothing is said and all hold it
class FolderHold {
 public:
  FolderHold() = default;  // of none
  explicit FolderHold(const std::filesystem::path& folder);
  FolderHold(FolderHold&& other) noexcept;
  FolderHold& operator=(FolderHold&& other) noexcept;
  ~FolderHold();

  // False where somebody else has it, or it is gone.
  bool is_held() const { return is_held_; }

 private:
  int descriptor_ = -1;
  bool is_held_ = false;
};

}  // namespace hottel
