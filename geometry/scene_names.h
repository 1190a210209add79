// What is called so in a scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/face.h"
#include "geometry/scene_table.h"

namespace hottel {

// Returns the surfaces whose name, or whose polyline's name, matches: equal, or equal up to a final '*'. Ascending.
// Throws UnknownName when there is none.
std::vector<std::uint32_t> surfaces_matching(const SceneTable& scene, const std::string& pattern);

// One face of the scene by name, "wall" or "wall:back". Throws UnknownName when there is none.
Face face_of(const SceneTable& scene, const std::string& name);

// "'a'", "'a' and 'b'", "'a', 'b', 'c' and 4 more"
std::string names_text(const SceneTable& scene, const std::vector<std::uint32_t>& surfaces);

// "the solid 'box'"
std::string solid_text(const SceneTable& scene, std::uint32_t group);

}  // namespace hottel
