#include "geometry/plane/arrangement/claims.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What a surface claims of the right (left) side of a piece that it lies on.
Claim2 claim_of(const Scene2& scene, const PieceSource2& source, bool right) {
  const Surface& surface = scene.surfaces[source.surface];
  const bool is_back = source.is_reversed == right;  // the front is the right side of the surface
  const Material* material = !is_back       ? &scene.materials[surface.material]
                             : surface.back ? &scene.materials[*surface.back]
                                            : nullptr;
  return {{{source.surface, is_back}, source.part}, material};
}

}  // namespace

SideOwner2 owner_of_side(const Scene2& scene, const PatchBases& patches, const std::vector<PieceSource2>& covering,
                         bool right, const SilentGroups2& is_silent) {
  if (covering.size() == 1) return {claim_of(scene, covering.front(), right), std::nullopt};
  std::vector<Claim2> claims;
  std::vector<Face> there, silent;
  for (const PieceSource2& source : covering) {
    claims.push_back(claim_of(scene, source, right));
    there.push_back(claims.back().face);
  }
  if (is_silent)
    silent = silent_fronts(patches, there, [&](std::uint32_t s) { return is_silent(scene.surfaces[s].group); });
  std::optional<SideOwner2> side;
  for (const Claim2& claim : claims) {
    if (std::ranges::find(silent, Face(claim.face)) != silent.end() || !patches.has_place(claim.face, there)) continue;
    if (!side)
      side = {claim, std::nullopt};
    else if (claim.material != nullptr && side->owner.material == nullptr)
      side->owner = claim;
    else if (claim.material != nullptr && !side->rival && !(*claim.material == *side->owner.material))
      side->rival = claim;
  }
  HOTTEL_REQUIRE(side.has_value());
  return *side;
}

bool has_material_on(const Scene2& scene, const PatchBases& patches, const std::vector<PieceSource2>& covering,
                     bool right, const SilentGroups2& is_silent) {
  std::vector<Face> there;
  for (const PieceSource2& source : covering) there.push_back(claim_of(scene, source, right).face);
  return std::ranges::any_of(there, [&](const Face& face) {
    return scene.surfaces[face.surface].material_of(face.is_back) &&
           !is_part_of_silent(patches, face.surface, there,
                              [&](std::uint32_t s) { return is_silent(scene.surfaces[s].group); });
  });
}

}  // namespace hottel
