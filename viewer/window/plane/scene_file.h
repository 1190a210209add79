// The file of a scene that is being edited.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Reads and writes the scene, and tells when someone else has written it.
class SceneFile2 {
 public:
  explicit SceneFile2(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }

  // Returns the scene of the file. Throws InputError.
  Scene2 read();
  // Writes the scene, whole or not at all. Throws OutputError, RequestError where it cannot be written, InputError for
  // a scene that is none (validate).
  void write(const Scene2& scene);
  // The same to another file, which is the scene's from now on.
  void write_as(const std::filesystem::path& path, const Scene2& scene);

  // True once for each time that the file was changed since it was read or written here.
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
