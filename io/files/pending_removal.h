// What is to vanish should a signal end the program.
#pragma once

#include <string>

namespace hottel {

// kFile:         the file
// kEmptyFolder:  the folder, if nothing is in it
// kFolder:       the folder and all that is in it
enum class Removal : unsigned char { kFile, kEmptyFolder, kFolder };

// A path that remove_pending() removes while this lives. (Of more than a hundred at a time some are left.)
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

// Removes all that is pending: files first, then folders. Async-signal-safe.
void remove_pending() noexcept;

}  // namespace hottel
