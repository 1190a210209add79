#include "viewer/window/watched_file.h"

#include <fstream>
#include <system_error>

namespace hottel {

// Nothing for what cannot be read.
std::optional<WatchedFile::Mark> WatchedFile::mark() const {
  std::error_code error;
  Mark mark{std::filesystem::last_write_time(path_, error), 0};
  if (!error) mark.size = std::filesystem::file_size(path_, error);
  if (error || !std::ifstream(path_)) return std::nullopt;
  return mark;
}

void WatchedFile::note() {
  seen_ = mark();
  is_gone_ = is_gone_ && !seen_;
}

FileNews WatchedFile::news() {
  const std::optional<Mark> now = mark();
  if (!now) return std::exchange(is_gone_, true) ? FileNews::kNone : FileNews::kGone;
  const bool was_gone = std::exchange(is_gone_, false), is_same = now == seen_;
  seen_ = now;
  return was_gone ? FileNews::kBack : is_same ? FileNews::kNone : FileNews::kChanged;
}

}  // namespace hottel
