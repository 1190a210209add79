// How far surfaces are divided: everywhere, and where light ends.
#pragma once

#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"

namespace hottel {

// Depths of the trees under the elements of faces with a material.
//
//   (1) every leaf has the depth `everywhere` at least
//   (2) an element that the border of a beam or of a shadow crosses is divided until it has the depth `at_borders`
struct RefinementLevels {
  int everywhere = 0, at_borders = 0;

  bool is_any() const { return everywhere > 0 || at_borders > 0; }
  friend bool operator==(const RefinementLevels&, const RefinementLevels&) = default;
};

// How much of an element a light reaches, of what has an area.
enum class Reach : unsigned char { kNothing, kPart, kAll };

// What several parts, or what was found so far, come to together. kPart stays.
class ReachSum {
 public:
  void add(Reach reach) {
    is_lit_ = is_lit_ || reach != Reach::kNothing;
    is_dark_ = is_dark_ || reach != Reach::kAll;
  }
  bool is_part() const { return is_lit_ && is_dark_; }

 private:
  bool is_lit_ = false, is_dark_ = false;
};

// Puts trees in the place of those of a scene's surfaces. REQUIRES one for each.
template <class Scene>
Scene with_trees(Scene scene, std::vector<SurfaceTrees> trees) {
  HOTTEL_REQUIRE(trees.size() == scene.surfaces.size());
  for (std::size_t s = 0; s < trees.size(); ++s) scene.surfaces[s].trees = std::move(trees[s]);
  return scene;
}

}  // namespace hottel
