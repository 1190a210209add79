// Scene files: JSON with exact numbers. docs/scene_format.md says what they hold.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// A scene of either dimension. In this version all are in the plane: files of dimension 3 are refused.
using Scene = std::variant<Scene2>;

// Returns the scene of a file, in the plane or in space as its "dimension" says.
//
//   (1) every number has exactly the value that is typed; validate(scene) holds
//   (2) surfaces are in the order of the file: edges, then the pieces of polylines
//   (3) Surface::line is the line of the edge, or of the first point of the piece
//
// Throws InputError with file, line and surface for everything that docs/scene_format.md does not allow, unknown and
// duplicate keys included: nothing is ignored.                      COST: linear; 10^6 edges take about 5 s.
Scene read_scene(const std::filesystem::path& file);

// The same for a text in memory.
Scene parse_scene(std::string_view text, const std::string& name_for_messages);

// The same for those who can use a scene in the plane only: others are refused.
Scene2 read_scene_2(const std::filesystem::path& file);
Scene2 parse_scene_2(std::string_view text, const std::string& name_for_messages);

// Returns the text of a scene file.
//
//   (1) it reads back to the same scene exactly: materials, surfaces, sky, grid and expectations
//   (2) groups are read back too when edges stand before polylines, as in every scene that was read
//   (3) one edge or polyline a line; short decimals as JSON numbers, other values as strings
//
// A polyline that stands before an edge is written as edges: the order decides who owns an overlap, so it is kept.
// REQUIRES: validate(scene) holds; names of materials are unique; texts are UTF-8.
// Throws RequestError when a value has more digits than a scene file may hold (kMaxNumberLength).
std::string write_scene_2(const Scene2& scene);

}  // namespace hottel
