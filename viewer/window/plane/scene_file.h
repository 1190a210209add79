// The file of a scene that is being edited.
#pragma once

#include <filesystem>
#include <utility>

#include "geometry/plane/scene/scene.h"
#include "io/scene/plane/map_defaults.h"
#include "viewer/window/watched_file.h"

namespace hottel {

// Reads and writes the scene, and tells when someone else has written it.
class SceneFile2 : public WatchedFile {
 public:
  // side: from which the polygons of a map are seen.
  explicit SceneFile2(std::filesystem::path path, MapSide2 side = MapSide2::kInside)
      : WatchedFile(std::move(path)), side_(side) {}

  // Returns the scene of the file. Throws InputError.
  Scene2 read();
  // Writes the scene, whole or not at all. Throws OutputError, RequestError where it cannot be written or the file is a
  // map or a drawing, InputError for a scene that is none (validate).
  void write(const Scene2& scene);
  // The same to another file, which is the scene's from now on.
  void write_as(const std::filesystem::path& path, const Scene2& scene);

 private:
  MapSide2 side_;
};

}  // namespace hottel
