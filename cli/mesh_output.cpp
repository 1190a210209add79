#include "cli/mesh_output.h"

#include <filesystem>
#include <vector>

#include "io/scene/space/mesh_writer.h"

namespace hottel {

void write_mesh(const std::string& out, MeshFormat3 format, const Scene3& scene, const Streams& streams) {
  const std::filesystem::path library = std::filesystem::path(out).replace_extension(".mtl");
  const WrittenMesh3 mesh = write_mesh_3(scene, format, library.filename().string());
  std::vector<OutputFile> files;
  if (!mesh.library.empty()) {
    files.push_back(streams.output(library.string()));
    files.back().write(mesh.library);
  }
  files.push_back(streams.output(out));
  files.back().write(mesh.bytes);
  for (OutputFile& file : files) file.finish();
  for (OutputFile& file : files) file.commit();
  for (const std::string& note : mesh.notes) streams.note(one_line(note));
}

}  // namespace hottel
