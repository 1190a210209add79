// The materials of scenes that are made up.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/scene_table.h"

namespace hottel {

// Indices into paints(). kLamp and kGlow emit.
enum Paint : std::uint32_t { kWhite, kRed, kBlue, kGrey, kLamp, kGlow, kWood };

// The materials of every generated scene.
std::vector<Material> paints();

// Drops the materials that no surface has; the others keep their order.
void drop_unused_materials(SceneTable& table);

}  // namespace hottel
