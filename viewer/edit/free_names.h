// Names that nothing in a scene has yet.
#pragma once

#include <string>
#include <unordered_set>

#include "geometry/scene_table.h"

namespace hottel {

// The names of a scene's surfaces, groups and lights, and of those that were made up since.
//
//   (1) a name that is given is that of no surface, group or light, and neither is that of any piece of it, NAME[k]
//   (2) each is given once
//   (3) a name made of one that may be a name (name_problem) may be one
//
// COST: linear to make; then a look-up for each name that is tried.
class FreeNames {
 public:
  explicit FreeNames(const SceneTable& scene);

  // "edge 1", "edge 2", ...: the first that is free.
  std::string numbered(const std::string& noun);
  // "box copy", "box copy 2", ...: the first that is free. A copy of a copy is called as one of the first.
  std::string copy_of(const std::string& name);
  // "box 2", "box 3", ...: the first that is free.
  std::string another(const std::string& name);

 private:
  std::string first_free(const std::string& stem, std::size_t number);
  void take(const std::string& name);

  std::unordered_set<std::string> taken_;  // with what stands before a '['
};

// Returns "white copy", "white copy 2", ...: the first that is not the name of a material of the scene.
std::string free_copy_of_material(const SceneTable& scene, const std::string& name);

}  // namespace hottel
