#include "io/scene/space/mesh_objects.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "geometry/space/arrangement/solids.h"
#include "geometry/space/scene/patches.h"
#include "io/scene/distinct_names.h"
#include "kernel/support/disjoint_sets.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The groups of closed meshes joined to those of patches on their fronts.
void join_patches(const Scene3& scene, DisjointSets& joined) try {
  const PatchCarriers3 carriers(scene);
  if (carriers.bases().is_empty()) return;
  const Solids3 solids(scene);
  const auto order = carriers.bases().outermost_first();
  if (solids.meshes().empty() || !order) return;
  std::vector<std::optional<std::uint32_t>> closed(scene.surfaces.size());  // the first group of its mesh
  for (std::uint32_t s = 0; s < closed.size(); ++s)
    if (const ClosedMesh3* mesh = solids.mesh_of(scene.surfaces[s].group); mesh != nullptr && !scene.surfaces[s].on)
      closed[s] = mesh->group;
  for (const std::uint32_t patch : *order) {
    if (carriers.bases().is_on_backs(patch)) continue;
    for (const std::uint32_t base : carriers.of(patch)) {
      if (!closed[base]) continue;
      closed[patch] = closed[base];
      joined.join(*closed[base], scene.surfaces[patch].group);
    }
  }
} catch (const InputError&) {
}

}  // namespace

std::vector<std::string> mesh_objects(const Scene3& scene) {
  const auto n = static_cast<std::uint32_t>(scene.groups.size());
  DisjointSets joined(n);
  std::map<std::string, std::uint32_t> bodies;
  for (std::uint32_t g = 0; g < n; ++g)
    if (!scene.groups[g].body.empty()) joined.join(bodies.emplace(scene.groups[g].body, g).first->second, g);
  join_patches(scene, joined);
  std::vector<std::size_t> count(n);
  for (std::uint32_t g = 0; g < n; ++g) ++count[joined.root(g)];
  if (std::ranges::none_of(count, [](std::size_t groups) { return groups > 1; })) return {};
  DistinctNames names;
  std::vector<std::string> name_of_first(n), objects;
  for (const bool is_alone : {false, true})
    for (std::uint32_t g = 0; g < n; ++g)
      if (joined.root(g) == g && (count[g] == 1) == is_alone)
        name_of_first[g] = names.take(scene.groups[g].body.empty() ? scene.groups[g].name : scene.groups[g].body);
  for (std::uint32_t g = 0; g < n; ++g) objects.push_back(name_of_first[joined.root(g)]);
  return objects;
}

}  // namespace hottel
