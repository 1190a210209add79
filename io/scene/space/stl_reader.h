// Meshes in STL files.
#pragma once

#include <string>
#include <string_view>

#include "io/scene/space/mesh.h"

namespace hottel {

// Whether bytes are a binary STL file, by (1) of parse_stl_3.
bool is_binary_stl_3(std::string_view bytes);

// Returns the mesh of an STL file, text or binary.
//
//   (1) it is binary iff it has 84 + 50 n bytes for the n that its bytes 80 to 83 say; a binary file may begin with
//       "solid" too
//   (2) coordinates of a text are exactly what is typed; those of a binary file exactly the floats that they are
//   (3) the front of a triangle is the side from which its points go counter-clockwise; its normal is passed over, and
//       so are names of solids, the 80 bytes before a binary file and the two bytes after each of its triangles
//   (4) keywords may be in letters of either case, and a text may have several solids
//
// Throws InputError with file and line, or with file and byte in a binary file: for a file that ends too early, a
// keyword that is not the one that follows, a facet of more or fewer than three points, a coordinate that is no number,
// no triangles. COST: linear.
Mesh3 parse_stl_3(std::string_view bytes, const std::string& file);

}  // namespace hottel
