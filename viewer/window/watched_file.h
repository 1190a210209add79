// A file that others may write too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace hottel {

// Tells when someone else has written a file.
class WatchedFile {
 public:
  explicit WatchedFile(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  // To be called before the file is read, and after it was written.
  void note() { seen_ = mark(); }
  // True once for each time that the file was changed since note(). A file that is gone has not: there is nothing to
  // read.
  bool has_changed();

 private:
  struct Mark {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Mark&, const Mark&) = default;
  };
  std::optional<Mark> mark() const;

  std::filesystem::path path_;
  std::optional<Mark> seen_;
};

}  // namespace hottel
