#include "io/files/scratch_folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "io/files/abandoned.h"
#include "io/files/output_file.h"

namespace hottel {
namespace {

std::filesystem::path place_of_temporaries() {
  std::error_code missing;
  const std::filesystem::path place = std::filesystem::temp_directory_path(missing);
  if (missing) throw OutputError("TMPDIR", "names no folder for temporary files: " + missing.message());
  return place;
}

}  // namespace

ScratchFolder::ScratchFolder() : ScratchFolder(place_of_temporaries()) {}

ScratchFolder::ScratchFolder(const std::filesystem::path& within) {
  remove_abandoned(within, Abandoned::kFolders);
  while (!hold_.is_held()) {
    std::string pattern = (within / temporary_folder_pattern()).string();
    if (!::mkdtemp(pattern.data()))
      throw OutputError(within.string(), "no folder can be made there: " + std::string(std::strerror(errno)));
    path_ = pattern;
    pending_ = PendingRemoval(pattern, Removal::kFolder);
    hold_ = FolderHold(path_);
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void ScratchFolder::touch() const { (void)::utimensat(AT_FDCWD, path_.c_str(), nullptr, 0); }

}  // namespace hottel
