#include "geometry/arrangement/claims_2.h"

#include "kernel/failure.h"

namespace hottel {

SideOwner2 owner_of_side(const Scene2& scene, const std::vector<PieceSource2>& covering, bool right) {
  HOTTEL_REQUIRE(!covering.empty());
  std::optional<SideOwner2> side;
  for (const PieceSource2& source : covering) {
    const Surface2& surface = scene.surfaces[source.surface];
    const bool is_back = source.is_reversed == right;  // the front is the right side of the surface
    const Material* material = !is_back       ? &scene.materials[surface.material]
                               : surface.back ? &scene.materials[*surface.back]
                                              : nullptr;
    const Claim2 claim{{source.surface, source.part, is_back}, material};
    if (!side)
      side = {claim, std::nullopt};
    else if (material != nullptr && side->owner.material == nullptr)
      side->owner = claim;
    else if (material != nullptr && !side->rival && !(*material == *side->owner.material))
      side->rival = claim;
  }
  return *side;
}

}  // namespace hottel
