#include "viewer/window/watched_file.h"

#include <system_error>

namespace hottel {

std::optional<WatchedFile::Mark> WatchedFile::mark() const {
  std::error_code error;
  Mark mark{std::filesystem::last_write_time(path_, error), 0};
  if (!error) mark.size = std::filesystem::file_size(path_, error);
  if (error) return std::nullopt;
  return mark;
}

bool WatchedFile::has_changed() {
  const std::optional<Mark> now = mark();
  if (!now || now == seen_) return false;
  seen_ = now;
  return true;
}

}  // namespace hottel
