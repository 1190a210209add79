#include "viewer/window/plane/scene_file.h"

#include "io/files/output_file.h"
#include "io/scene/plane/map_reader.h"
#include "io/scene/plane/svg_reader.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel {

Scene2 SceneFile2::read() {
  note();
  return read_scene_2(path(), nullptr, side_);
}

void SceneFile2::write(const Scene2& scene) {
  validate(scene);
  if (is_map_2(path()))
    throw RequestError(path().string() + " is a map, which holds no materials and no light: save as a .json");
  if (is_svg_2(path())) throw RequestError(path().string() + " is a drawing, which holds no light: save as a .json");
  write_output_file(path(), write_scene_2(scene));
  note();
}

void SceneFile2::write_as(const std::filesystem::path& path, const Scene2& scene) {
  SceneFile2 other(path);
  other.write(scene);
  *this = other;
}

}  // namespace hottel
