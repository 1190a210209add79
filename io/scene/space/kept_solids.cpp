#include "io/scene/space/kept_solids.h"

#include <algorithm>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/arrangement/solids.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool is_solid(const Solids3& solids, std::uint32_t group) {
  const ClosedMesh3* mesh = solids.mesh_of(group);
  return mesh != nullptr && mesh->kind == ClosedMesh3::Kind::kSolid;
}

bool has_solid(const Solids3& solids) {
  return std::ranges::any_of(solids.meshes(),
                             [](const ClosedMesh3& mesh) { return mesh.kind == ClosedMesh3::Kind::kSolid; });
}

}  // namespace

std::vector<std::string> notes_on_solids(const Scene3& scene, const std::function<Scene3()>& read,
                                         const std::function<std::string(const std::string&)>& name_in_file) try {
  const Solids3 solids(scene);
  const Scene3 again = read();
  const Solids3 read_solids(again);
  std::vector<std::string> hollow;
  bool has_more = !has_solid(solids) && has_solid(read_solids);
  if (again.groups.size() == 1 && has_solid(read_solids) && !has_more) return {};
  const auto is_kept = [&](const std::string& name) {
    for (std::uint32_t g = 0; g < again.groups.size(); ++g)
      if (again.groups[g].name == name) return is_solid(read_solids, g);
    return false;
  };
  for (const ClosedMesh3& mesh : solids.meshes())
    if (mesh.kind == ClosedMesh3::Kind::kSolid && !is_kept(name_in_file(scene.groups[mesh.group].name)))
      hollow.push_back(mesh.name);
  std::vector<std::string> notes;
  if (!hollow.empty())
    notes.push_back("solid in the scene, hollow in the file, whose groups do not close: " + listed_names(hollow) +
                    "; what they cover, as the floor under them, is lit there");
  if (has_more) notes.push_back("nothing is solid in the scene, but what closes in the file is");
  return notes;
} catch (const InputError&) {
  return {};
}

}  // namespace hottel
