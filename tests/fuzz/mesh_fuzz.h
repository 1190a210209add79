// What is done with a mesh that a fuzzer makes up.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/scene/space/mesh_reader.h"
#include "io/scene/space/mesh_writer.h"
#include "kernel/support/failure.h"

namespace hottel {

// Reads bytes as a mesh; if it is one, writes it in every format. What is read of PLY and OFF again has the same faces,
// where nothing was rounded or cut.
inline void fuzz_mesh(MeshFormat3 format, std::string_view bytes) {
  Scene3 scene;
  try {
    scene = scene_of(parse_mesh_3(format, bytes, "fuzz.x")).scene;
  } catch (const InputError&) {
    return;
  }
  for (const MeshFormat3 to : {MeshFormat3::kObj, MeshFormat3::kPly, MeshFormat3::kOff, MeshFormat3::kStl}) {
    WrittenMesh3 mesh;
    try {
      mesh = write_mesh_3(scene, to, "fuzz.mtl");
    } catch (const RequestError&) {
      continue;  // a number that the format does not have
    }
    if (!mesh.notes.empty()) continue;
    const Scene3 again = scene_of(parse_mesh_3(to, mesh.bytes, "fuzz.x")).scene;
    if (again.polygons != scene.polygons || again.groups != scene.groups) std::abort();
  }
}

}  // namespace hottel
