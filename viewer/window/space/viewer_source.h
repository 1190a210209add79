// Where the scene of a viewer in space comes from.
#pragma once

#include <filesystem>
#include <functional>

#include "geometry/space/scene/scene.h"

namespace hottel {

struct ViewerSource3 {
  std::filesystem::path file;
  std::function<Scene3()> read;  // throws InputError
};

}  // namespace hottel
