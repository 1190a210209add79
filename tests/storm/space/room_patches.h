// What patches must leave as it was in a furnished room.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel::storm {

class RoomSubject3;

// A scene with some patches more, of any of its materials: on faces and on each other, on fronts and on backs, with and
// without a material on their own. They are what is left of a face between lines parallel to its sides, triangles
// across a corner of it, or all of it; of what is bent they may be on all of its triangles. `root[s]`: the first
// surface that surface s lies on, itself where it is none of the patches.
struct PatchedRoom3 {
  Scene3 scene;
  std::vector<std::uint32_t> root;
};
PatchedRoom3 with_patches(Scene3 scene, std::uint64_t chance);

// The law `patches` (room_laws_3): what is wrong, or nothing.
std::string room_patches_are_broken(const RoomSubject3& subject);

}  // namespace hottel::storm
