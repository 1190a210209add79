// Scenes in which nothing can stand between two faces, nor between a face and the sky.
#pragma once

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// Returns whether a scene is one closed convex room: fronts inside, no back with a material.
//
//   (1) exact. Then every front sees every other one that it faces, whole, and nothing else
//   (2) walls may be divided anyhow, edges of one wall may end within those of others
//
// REQUIRES: the occluders are the polygons of a valid scene, as they are where its arrangement is plain. COST: at worst
// a sign for each polygon and vertex, where the polygons are those of a convex body; else few.
bool is_convex_room(const Scene3& scene, const Occluders3& occluders);

// Returns whether no face with a material has anything before it: each sees the sky, whole, and nothing else. Exact.
//
// REQUIRES and COST as above.
bool faces_nothing(const Scene3& scene, const Occluders3& occluders);

}  // namespace hottel
