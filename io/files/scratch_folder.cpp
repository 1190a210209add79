#include "io/files/scratch_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "io/files/abandoned.h"
#include "io/files/output_file.h"

namespace hottel {

ScratchFolder::ScratchFolder(const std::filesystem::path& within) {
  remove_abandoned(within, Abandoned::kFolders);
  for (bool is_held = false; !is_held;) {
    std::string pattern = (within / temporary_folder_pattern()).string();
    if (!::mkdtemp(pattern.data()))
      throw OutputError(within.string(), "no folder can be made there: " + std::string(std::strerror(errno)));
    path_ = pattern;
    pending_ = PendingRemoval(pattern, Removal::kFolder);
    // Commands inherit it: the folder is in use for as long as one runs that outlives this process.
    held_ = ::open(pattern.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
    is_held = held_ < 0 ? std::filesystem::exists(path_) : hold_temporary(held_, pattern);
    if (!is_held && held_ >= 0) ::close(held_);
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  if (held_ >= 0) ::close(held_);
}

void ScratchFolder::touch() const { (void)::utimensat(AT_FDCWD, path_.c_str(), nullptr, 0); }

}  // namespace hottel
