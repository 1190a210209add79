#include "parallel/scene_message.h"

#include <cstdint>
#include <vector>

#include "geometry/element.h"
#include "io/scene/binary_scene.h"

namespace hottel {
namespace {

void put_leaves(const std::vector<TreeNode>& leaves, MessageWriter& writer) {
  writer.put(std::uint64_t{leaves.size()});
  for (const TreeNode& leaf : leaves) {
    writer.put(leaf.part, leaf.path.depth());
    for (int level = 0; level < leaf.path.depth(); ++level) writer.put(leaf.path.digit(level));
  }
}

std::vector<TreeNode> take_leaves(MessageReader& reader) {
  std::vector<TreeNode> leaves(reader.take<std::uint64_t>());
  for (TreeNode& leaf : leaves) {
    int depth = 0;
    reader.take_into(leaf.part, depth);
    for (int level = 0; level < depth; ++level) leaf.path = leaf.path.child(reader.take<int>());
  }
  return leaves;
}

template <class SomeScene>
void put_any(SomeScene& scene, MessageWriter& writer) {
  scene.lights.clear();
  scene.light_places.clear();
  scene.grids.clear();
  scene.expect.clear();
  writer.put_text(binary_scene(scene));
  std::vector<std::uint32_t> with_trees;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (!scene.surfaces[s].trees.is_empty()) with_trees.push_back(s);
  writer.put(std::uint64_t{with_trees.size()});
  for (const std::uint32_t s : with_trees) {
    writer.put(s);
    for (const bool is_back : {false, true}) put_leaves(scene.surfaces[s].trees.of(is_back), writer);
  }
}

}  // namespace

void put_scene(Scene2 scene, MessageWriter& writer) { put_any(scene, writer); }
void put_scene(Scene3 scene, MessageWriter& writer) {
  scene.camera.reset();
  put_any(scene, writer);
}

Scene take_scene(MessageReader& reader) {
  Scene scene = changeable(parse_binary_scene(reader.take_text(), "the scene of rank 0"));
  SceneTable& table = std::visit([](auto& its) -> SceneTable& { return its; }, scene);
  for (auto left = reader.take<std::uint64_t>(); left > 0; --left) {
    SurfaceTrees& trees = table.surfaces.at(reader.take<std::uint32_t>()).trees;
    trees.front = take_leaves(reader);
    trees.back = take_leaves(reader);
  }
  return scene;
}

}  // namespace hottel
