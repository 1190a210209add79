#include "viewer/window/plane/scene_file.h"

#include <system_error>

#include "io/files/output_file.h"
#include "io/scene/scene_json.h"

namespace hottel {

std::optional<SceneFile2::Mark> SceneFile2::mark() const {
  std::error_code error;
  Mark mark{std::filesystem::last_write_time(path_, error), 0};
  if (!error) mark.size = std::filesystem::file_size(path_, error);
  if (error) return std::nullopt;
  return mark;
}

Scene2 SceneFile2::read() {
  seen_ = mark();
  return read_scene_2(path_);
}

void SceneFile2::write(const Scene2& scene) {
  validate(scene);
  write_output_file(path_, write_scene_2(scene));
  seen_ = mark();
}

void SceneFile2::write_as(const std::filesystem::path& path, const Scene2& scene) {
  SceneFile2 other(path);
  other.write(scene);
  *this = other;
}

bool SceneFile2::has_changed() {
  const std::optional<Mark> now = mark();
  if (!now || now == seen_) return false;  // a file that is gone is not offered: there is nothing to read
  seen_ = now;
  return true;
}

}  // namespace hottel
