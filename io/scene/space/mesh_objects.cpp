#include "io/scene/space/mesh_objects.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>

#include "geometry/space/arrangement/solids.h"
#include "geometry/space/scene/patches.h"
#include "io/scene/distinct_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Groups joined to others.
class JoinedGroups {
 public:
  explicit JoinedGroups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t first(std::uint32_t g) const {
    while (parent_[g] != g) g = parent_[g];
    return g;
  }
  // The first of a keeps being that.
  void join(std::uint32_t a, std::uint32_t b) { parent_[first(b)] = first(a); }

 private:
  std::vector<std::uint32_t> parent_;
};

// The groups of closed meshes joined to those of patches on their fronts.
void join_patches(const Scene3& scene, JoinedGroups& joined) try {
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
  JoinedGroups joined(n);
  std::map<std::string, std::uint32_t> bodies;
  for (std::uint32_t g = 0; g < n; ++g)
    if (!scene.groups[g].body.empty()) joined.join(bodies.emplace(scene.groups[g].body, g).first->second, g);
  join_patches(scene, joined);
  std::vector<std::size_t> count(n);
  for (std::uint32_t g = 0; g < n; ++g) ++count[joined.first(g)];
  if (std::ranges::none_of(count, [](std::size_t groups) { return groups > 1; })) return {};
  DistinctNames names;
  std::vector<std::string> name_of_first(n), objects;
  for (const bool is_alone : {false, true})
    for (std::uint32_t g = 0; g < n; ++g)
      if (joined.first(g) == g && (count[g] == 1) == is_alone)
        name_of_first[g] = names.take(scene.groups[g].body.empty() ? scene.groups[g].name : scene.groups[g].body);
  for (std::uint32_t g = 0; g < n; ++g) objects.push_back(name_of_first[joined.first(g)]);
  return objects;
}

}  // namespace hottel
