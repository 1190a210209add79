// Files of meshes, of every format that is read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/text_file.h"
#include "io/scene/space/mesh.h"
#include "io/scene/space/mesh_adder.h"

namespace hottel {

// The formats of meshes.
enum class MeshFormat3 : unsigned char { kObj, kPly, kOff, kStl };

// Their endings, for messages.
inline constexpr const char* kMeshEndings3 = ".obj, .ply, .off or .stl";

// Returns the format that the ending of a file stands for: .obj, .ply, .off or .stl, in letters of either case.
std::optional<MeshFormat3> mesh_format_3(const std::filesystem::path& file);

// Returns the mesh of the bytes of a file. `files` are those that it may name.
// Throws InputError as parse_obj_3, parse_ply_3, parse_off_3 and parse_stl_3 do. COST: linear.
Mesh3 parse_mesh_3(MeshFormat3 format, std::string_view bytes, const std::string& file,
                   const TextSource& files = read_text_file);

// Returns the scene that a file of a mesh is by itself (scene_of). REQUIRES that mesh_format_3 knows its ending.
MeshScene3 read_mesh_scene_3(const std::filesystem::path& file, Triangulator3* triangulator = nullptr,
                             PassedOver* passed_over = nullptr);

}  // namespace hottel
