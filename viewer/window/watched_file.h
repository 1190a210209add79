// A file that others may write too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace hottel {

// What has become of a file since one looked at it last.
enum class FileNews : unsigned char {
  kNone,
  kChanged,  // someone else has written it
  kGone,     // it is not there any more, or cannot be read
  kBack,     // it is there again, and can be read
};

// Tells when someone else has written, taken away or brought back a file.
class WatchedFile {
 public:
  explicit WatchedFile(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  // To be called before the file is read, and after it was written.
  void note();
  // What has become of the file since note() or the last call: each change is told once. COST: it is opened.
  FileNews news();
  // Whether the last that news() told is that it is gone.
  bool is_gone() const { return is_gone_; }

 private:
  struct Mark {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Mark&, const Mark&) = default;
  };
  std::optional<Mark> mark() const;

  std::filesystem::path path_;
  std::optional<Mark> seen_;
  bool is_gone_ = false;
};

}  // namespace hottel
