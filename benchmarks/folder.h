// A place for files that a benchmark needs.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace hottel::benchmarks {

// A directory of this process, removed at the end.
class Folder {
 public:
  // name: of the benchmark; two folders of one process need two names.
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("hottel-" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace hottel::benchmarks
