// Meshes in PLY files.
#pragma once

#include <string>
#include <string_view>

#include "io/scene/space/mesh.h"

namespace hottel {

// Returns the mesh of a PLY file: text, or binary of either byte order.
//
//   (1) points are x, y, z of the element vertex, numbers of any type: of a text exactly as they are typed, of a binary
//       file exactly the integers, floats and doubles that they are
//   (2) faces are the lists vertex_indices or vertex_index of the element face, counted from 0
//   (3) all other properties and elements (colours, normals, edges) are passed over, but for triangle strips, which are
//       refused: they are faces too
//   (4) nothing is kept of a count before the file is known to be long enough for it
//
// Throws InputError with file and line, or with file and byte in a binary file: for what parse_ply_header refuses, a
// file that ends too early or goes on after its last element, a coordinate that is no number, an index of no vertex, a
// face of fewer than three vertices, no faces. COST: linear.
Mesh3 parse_ply_3(std::string_view bytes, const std::string& file);

}  // namespace hottel
