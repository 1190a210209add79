// What is called so in a scene.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/face.h"
#include "geometry/scene_table.h"

namespace hottel {

// Returns the surfaces whose name, or whose polyline's or group's name, matches, ascending. The first of these that
// finds some counts:
//
//   (1) names equal to the pattern, whichever characters they contain
//   (2) of a pattern with a '*' at its end and none before, names that begin with what is before it: "room[*" too
//   (3) names that it describes as a file name of a shell: '*' any characters, '?' one, "[abc]", "[a-c]", "[!a-c]" one
//       of these; a bracket by itself is "[[]". Characters are those of UTF-8
//
// Throws UnknownName when there is none. COST: linear as a rule.
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
