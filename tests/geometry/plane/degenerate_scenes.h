// The scenes of scenes/degenerate/.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"

namespace hottel::testing_scenes {

inline std::filesystem::path degenerate_folder() {
  return std::filesystem::path(HOTTEL_SOURCE_DIR) / "scenes" / "degenerate";
}

inline Scene2 degenerate(const std::string& stem) { return read_scene_2(degenerate_folder() / (stem + ".json")); }

inline std::vector<std::string> degenerate_stems() {
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(degenerate_folder()))
    if (entry.path().extension() == ".json") result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace hottel::testing_scenes
