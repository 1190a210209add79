#include "geometry/space/arrangement/side_claims.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {

SideOwner3 owner_of_side(const Scene3& scene, const std::vector<PlaceSource3>& sources, bool is_up,
                         const std::function<bool(std::uint32_t group)>& is_silent) {
  const auto material = [&scene](const Face& face) -> const Material* {
    const std::optional<std::uint32_t> m = scene.surfaces[face.surface].material_of(face.is_back);
    return m ? &scene.materials[*m] : nullptr;
  };
  std::optional<SideOwner3> side;
  for (const PlaceSource3& source : sources) {
    const Face face{source.surface, source.is_front_up != is_up};
    if (!face.is_back && is_silent(scene.surfaces[face.surface].group)) continue;
    if (!side)
      side = {face, std::nullopt};
    else if (material(face) != nullptr && material(side->owner) == nullptr)
      side->owner = face;
    else if (material(face) != nullptr && !side->rival && !(*material(face) == *material(side->owner)))
      side->rival = face;
  }
  HOTTEL_REQUIRE(side.has_value());
  return *side;
}

bool has_material_on(const Scene3& scene, const std::vector<PlaceSource3>& sources, bool is_up) {
  return std::any_of(sources.begin(), sources.end(), [&](const PlaceSource3& source) {
    return scene.surfaces[source.surface].material_of(source.is_front_up != is_up).has_value();
  });
}

}  // namespace hottel
