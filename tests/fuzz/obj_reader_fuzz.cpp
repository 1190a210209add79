// Any bytes as a mesh, and as its materials: refused with InputError, or a valid scene that is written and read again.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_adder.h"
#include "io/scene/space/obj_reader.h"
#include "kernel/support/failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // The file that it names, whatever its name: what follows the last "newmtl", from there on.
  const auto library = [&](const std::filesystem::path&) {
    return std::string(text.substr(std::min(text.rfind("newmtl"), text.size())));
  };
  hottel::MeshScene3 mesh;
  try {
    mesh = hottel::scene_of(hottel::parse_obj_3(text, "fuzz.obj", library));
  } catch (const hottel::InputError&) {
    return 0;
  }
  std::string written;
  try {
    written = hottel::write_scene_3(mesh.scene);
  } catch (const hottel::RequestError&) {
    return 0;  // a number too long for a scene file
  }
  const hottel::Scene3 again = hottel::parse_scene_3(written, "written.json", library);
  if (again.polygons != mesh.scene->polygons || again.groups != mesh.scene->groups) std::abort();
  return 0;
}
