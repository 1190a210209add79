#include "cli/mesh_output.h"

#include <filesystem>
#include <string>
#include <vector>

#include "cli/scene_input.h"
#include "io/scene/space/mesh_writer.h"
#include "kernel/support/failure.h"

namespace hottel {

namespace {

// Materials go beside a mesh, where nobody has named a file: nothing that was read is there.
void require_unread(const Scene3& scene, const std::string& out, const std::filesystem::path& library) {
  for (const std::string& source : scene.sources)
    if (is_same_file(source, library))
      throw UsageError("the materials of " + out + " would overwrite " + library.string() +
                       ", from which the scene was read: choose another name");
}

}  // namespace

void write_mesh(const std::string& out, MeshFormat3 format, const Scene3& scene, const Streams& streams) {
  const std::filesystem::path library = std::filesystem::path(out).replace_extension(".mtl");
  const WrittenMesh3 mesh = write_mesh_3(scene, format, library.filename().string());
  std::vector<OutputFile> files;
  if (!mesh.library.empty()) {
    require_unread(scene, out, library);
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
