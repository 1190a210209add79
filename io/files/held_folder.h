// Folders that one run at a time has.
#pragma once

#include <filesystem>
#include <string>

#include "io/files/abandoned.h"
#include "io/files/pending_removal.h"

namespace hottel {

// Says to all processes that a folder is in use, for as long as this lives and as commands run that this process
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

// A folder of a name that no other has, in another one; removed at the end with all that is in it, also by a signal.
// Those of its kind that killed runs left there are removed first (abandoned.h).
class OwnFolder {
 public:
  // Throws OutputError where none can be made.
  OwnFolder(const std::filesystem::path& place, Abandoned kind);
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  PendingRemoval pending_;
  FolderHold hold_;
};

}  // namespace hottel
