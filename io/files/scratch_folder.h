// A folder for files that are of no use to anybody once the run is over.
#pragma once

#include <filesystem>

#include "io/files/folder_hold.h"
#include "io/files/pending_removal.h"

namespace hottel {

// A folder of its own, in another one, with whatever comes into it.
//
//   (1) it is removed at the end, also by a signal
//   (2) those that killed runs left beside it are removed when it is made (abandoned.h); it is held itself, for as long
//       as this process, or a command that it started, is there
class ScratchFolder {
 public:
  // Throw OutputError where no folder can be made.
  ScratchFolder();  // in the system's folder of temporary files
  explicit ScratchFolder(const std::filesystem::path& within);
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }
  // Says that it is in use to machines that share the disk but are not told who holds what: once a day is enough.
  void touch() const;

 private:
  std::filesystem::path path_;
  PendingRemoval pending_;
  FolderHold hold_;
};

}  // namespace hottel
