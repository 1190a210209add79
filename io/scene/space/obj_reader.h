// Meshes in OBJ files.
#pragma once

#include <string>
#include <string_view>

#include "io/files/text_file.h"
#include "io/scene/space/mesh.h"

namespace hottel {

// Returns the mesh of an OBJ file. docs/scene_format.md says what is read (v, f, g, o, usemtl, mtllib), passed over
// because it says nothing of shape or light, and refused; nothing else is there.
//
// MTL files are found relative to the folder of `file`. Throws InputError with file and line.          COST: linear.
Mesh3 parse_obj_3(std::string_view text, const std::string& file, const TextSource& files = read_text_file);

}  // namespace hottel
