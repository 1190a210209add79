// Scenes as bytes: what a scene file says, read already, for those who read it again and again.
#pragma once

#include <string>
#include <string_view>

#include "io/scene/scene_json.h"

namespace hottel {

// Whether bytes begin as a binary scene does.
inline bool is_binary_scene(std::string_view bytes) { return bytes.starts_with("\x93hottel scene\n"); }
// Whether a file name ends in .hs.
inline bool is_binary_scene_name(std::string_view file) { return file.size() > 3 && file.ends_with(".hs"); }

// Returns a scene as bytes: a head with the number of the layout, what follows and the sum (CRC-32) of that.
//
//   (1) parse_binary_scene returns the same scene, exactly: numbers, names, order, lines, and the file that it was
//       read from, which messages name; but for trees below elements, which no file has
//   (2) the same scene gives the same bytes
// COST: linear; some 60 bytes an edge.
std::string binary_scene(const Scene2& scene);
std::string binary_scene(const Scene3& scene);

// Reads it. Throws InputError, naming `name`, for what begins otherwise, has another layout, breaks off, or is damaged.
// COST: linear; 10^6 edges take a second.
ValidScene parse_binary_scene(std::string_view bytes, const std::string& name);

}  // namespace hottel
