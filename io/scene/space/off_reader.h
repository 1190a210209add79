// Meshes in OFF files.
#pragma once

#include <string>
#include <string_view>

#include "io/scene/space/mesh.h"

namespace hottel {

// Returns the mesh of an OFF file (Geomview's object file format), as text.
//
//   (1) coordinates are exactly what is typed; vertices of a face are counted from 0
//   (2) of STOFF, COFF, NOFF and their combinations the textures, colours and normals are passed over: what stands in
//       the line of a vertex after x y z. Colours of faces are what stands in the line after the last vertex
//   (3) '#' begins a comment; the number of edges may be left out and is not used
//   (4) nothing is kept of a count before the file is known to be long enough for it
//
// Throws InputError with file and line: for OFF BINARY, points of more coordinates (4OFF, nOFF), a file that ends too
// early or goes on after its last face, a coordinate that is no number, an index of no vertex, a face of fewer than
// three vertices, no faces. COST: linear.
Mesh3 parse_off_3(std::string_view text, const std::string& file);

}  // namespace hottel
