// Scene files: JSON with exact numbers, and meshes. docs/scene_format.md says what they hold.
//
//   Scene2 scene = read_scene_2("scenes/analytic/square_radiosity.json");
//   material_called(scene, "lit").emission = Spectrum::scalar(2);
//   std::ofstream("brighter.json") << write_scene_2(scene);
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>

#include "geometry/plane/scene/scene.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

class PassedOver;
class Triangulator3;
enum class MapSide2 : unsigned char;

// As io/files/text_file.h has them.
std::string read_text_file(const std::filesystem::path& file);
using TextSource = std::function<std::string(const std::filesystem::path&)>;

// A scene of either dimension.
using Scene = std::variant<Scene2, Scene3>;
// The same, known to be valid: what readers return, and simulations take as it is.
using ValidScene = std::variant<ValidScene2, ValidScene3>;
// Returns it as one that may be changed at will.
Scene changeable(ValidScene scene);

// Returns the scene of a file. The file is one of these:
//
//   JSON                        in the plane or in space, as its "dimension" says
//   a map (.geojson, .wkt)      in the plane, its polygons seen from `side`, by default from inside
//   a drawing (.svg)            in the plane
//   a mesh (mesh_format_3)      in space
//   a deck of View3D (.vs3)     in space
//   a binary scene              in the plane or in space; its first bytes tell it (binary_scene.h)
//
// The triangulator cuts polygons that are not plane; without one they are refused. `passed_over` counts what is passed
// over in maps, drawings and meshes.
//
//   (1) every number has exactly the value that is typed
//   (2) surfaces are in the order of the file: edges, then the pieces of polylines; or polygons, then faces of meshes
//   (3) Surface::line is the line of the edge, of the first point of the piece, of the polygon, or of the mesh that has
//       the face, whose own place is Surface::in_mesh
//
// Throws InputError with file, line and surface for everything that docs/scene_format.md does not allow, unknown and
// duplicate keys included. Nothing is ignored but what `passed_over` counts; where it is null the same is, uncounted.
// hottel_files.h has Triangulator3, PassedOver and MapSide2. COST: linear; 10^6 edges take about 5 s.
ValidScene read_scene(const std::filesystem::path& file, Triangulator3* triangulator = nullptr,
                      PassedOver* passed_over = nullptr, MapSide2 side = {});

// The same for a text without a file name, and so without an ending. It may be JSON; GeoJSON, which has a "type"; a
// drawing, which begins with '<'; a mesh that begins with solid, ply, OFF or a statement of OBJ, or has the length that
// a binary STL file states; or well-known text.
ValidScene parse_any_scene(std::string_view text, const std::string& name_for_messages,
                           Triangulator3* triangulator = nullptr, PassedOver* passed_over = nullptr,
                           MapSide2 side = {});

// The same for a JSON text in memory. Files that it names are found relative to the folder of name_for_messages, and
// come from `files`.
ValidScene parse_scene(std::string_view text, const std::string& name_for_messages,
                       const TextSource& files = read_text_file);

// The same for one dimension only: a scene of the other one is refused before its surfaces are read.
ValidScene2 read_scene_2(const std::filesystem::path& file, PassedOver* passed_over = nullptr, MapSide2 side = {});
ValidScene2 parse_scene_2(std::string_view text, const std::string& name_for_messages);
ValidScene3 read_scene_3(const std::filesystem::path& file, Triangulator3* triangulator = nullptr,
                         PassedOver* passed_over = nullptr);
ValidScene3 parse_scene_3(std::string_view text, const std::string& name_for_messages,
                          const TextSource& files = read_text_file);

// Returns the text of a scene file.
//
//   (1) it reads back to the same scene exactly, but for what no scene file holds: where things stood in files (file,
//       sources, lines; those of the text take their place), trees, groups and bases that no surface has, and in the
//       plane what a light that moves has turned so far: its direction is written turned, rounded to doubles unless by
//       quarters of a turn. Faces of meshes become polygons
//   (2) in the plane groups are read back too when edges stand before polylines, as in every scene that was read; in
//       space when they are numbered by their first surfaces, as there
//   (3) one edge, polyline or polygon a line; short decimals as JSON numbers, other values as strings
//
// A polyline that stands before an edge is written as edges: the order decides who owns an overlap, so it is kept.
// REQUIRES: validate(scene) holds; names of materials are unique; texts are UTF-8.
// Throws RequestError when a value has more digits than a scene file may hold (kMaxNumberLength).
std::string write_scene_2(const Scene2& scene);
std::string write_scene_3(const Scene3& scene);

}  // namespace hottel
