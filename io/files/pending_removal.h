// What is to vanish should a signal end the program.
#pragma once

#include <string>

namespace hottel {

// kFile:         the file
// kEmptyFolder:  the folder, if nothing is in it
// kFolder:       the folder and all that is in it, to a depth of eight folders
enum class Removal : unsigned char { kFile, kEmptyFolder, kFolder };

// A path that remove_pending() removes while this lives. (Of more than a hundred at a time some are left.) The end of
// its life removes nothing: the path is no longer pending, that is all.
//
//   (1) made without a path, or moved from, it stands for nothing
class PendingRemoval {
 public:
  PendingRemoval() = default;
  PendingRemoval(const std::string& path, Removal removal);
  PendingRemoval(PendingRemoval&& other) noexcept;
  PendingRemoval& operator=(PendingRemoval&& other) noexcept;
  ~PendingRemoval();

 private:
  int slot_ = -1;
};

// Removes all that is pending: files and full folders first, then empty folders, until none can be removed any more.
// What cannot be removed is left, without a word. Async-signal-safe.
void remove_pending() noexcept;

}  // namespace hottel
