// Random trees under the elements of a scene in the plane.
#pragma once

#include <random>

#include "geometry/plane/scene/scene.h"

namespace hottel {

inline void append_random_leaves(std::vector<TreeNode>& leaves, const TreeNode& node, int children, int depth,
                                 std::mt19937& random) {
  if (depth == 0 || random() % 2 == 0) {
    leaves.push_back(node);
    return;
  }
  for (int digit = 0; digit < children; ++digit)
    append_random_leaves(leaves, {node.part, node.path.child(digit)}, children, depth - 1, random);
}

// Of both faces of some surfaces, not deeper than asked for.
inline Scene2 with_random_trees(Scene2 scene, int depth, unsigned seed) {
  std::mt19937 random(seed);
  for (Surface& surface : scene.surfaces) {
    if (random() % 4 == 0) surface.elements = 3;
    for (const bool is_back : {false, true}) {
      if (!surface.material_of(is_back) || random() % 3 == 0) continue;
      std::vector<TreeNode>& leaves = is_back ? surface.trees.back : surface.trees.front;
      for (std::uint32_t part = 0; part < surface.elements; ++part)
        append_random_leaves(leaves, {part, {}}, 2, depth, random);
    }
  }
  return scene;
}

}  // namespace hottel
