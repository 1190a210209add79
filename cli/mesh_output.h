// Scenes written as meshes, for the commands that write scenes.
#pragma once

#include <string>

#include "cli/streams.h"
#include "geometry/space/scene/scene.h"
#include "io/scene/space/mesh_reader.h"

namespace hottel {

// Writes a scene to the file of a mesh, and for OBJ its materials to a file beside it, that ends in .mtl; all are whole
// before one appears. Remarks tell what the file does not hold (write_mesh_3). Throws RequestError as write_mesh_3
// does.
void write_mesh(const std::string& out, MeshFormat3 format, const Scene3& scene, const Streams& streams);

}  // namespace hottel
