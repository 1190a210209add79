// What is called so in a scene.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/face.h"
#include "geometry/scene_table.h"

namespace hottel {

// Returns the surfaces whose name, or whose polyline's name, matches: equal, or equal up to a final '*'. Ascending;
// "*" alone matches all. Throws UnknownName when there is none.
std::vector<std::uint32_t> surfaces_matching(const SceneTable& scene, const std::string& pattern);

// Returns the face of that name, "wall" or "wall:back". Throws UnknownName when there is none; the sky is no
// face. COST: linear.
Face face_of(const SceneTable& scene, const std::string& name);

// Returns the name of a face: "wall" or "wall:back". face_of(scene, face_name(scene, face)) == face.
std::string face_name(const SceneTable& scene, const Face& face);

// Returns the material of that name, to be changed. Throws UnknownName when there is none. COST: linear.
Material& material_called(SceneTable& scene, const std::string& name);

// Returns the hints of a message about a material that is not defined: names near to it, and those there are.
std::vector<std::string> undefined_material_hints(const SceneTable& scene, std::string_view name);

// Returns the names for a message, each quoted: "'a'", "'a' and 'b'", or "'a', 'b', 'c' and 4 more" where there are
// more than four.
std::string names_text(const SceneTable& scene, const std::vector<std::uint32_t>& surfaces);

// Returns how messages call the solid that a group makes: "the solid 'box'".
std::string solid_text(const SceneTable& scene, std::uint32_t group);

}  // namespace hottel
